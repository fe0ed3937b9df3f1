// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "dem/surface_points.hpp"
#include "dem/surface_spline.hpp"
#include "dem/touch.hpp"

namespace porefines::dem {

/// Grains given by a sampled signed distance, ready for contact.
///
/// The surface of reference is s = 0 of the spline through the samples. How well that follows the
/// sample is the matter of geom::VoxelSolid (corners rounded by its sigma, about 0.1-0.2 voxel on
/// curved grains); how well touches follow it is Newton's tolerance (1e-6 voxel).
struct DistanceField {
  Vec3 corner;     ///< [m] of the sample's box in the coordinates of the particles
  Real pixel = 1;  ///< [m]
  SurfaceSpline spline;
  SurfacePoints points;

  /// Lower bound of the distance from anywhere in a block of 2 x 2 x 2 voxels to the points of the
  /// surface [voxels]; -1 inside grains.
  std::vector<float> clearance;
  Int3 first_block{0, 0, 0};
  Int3 blocks{0, 0, 0};
};

/// @param largest  [m] radius + reach of the largest sphere: beyond that from every surface a query
///                 costs one load. The window of the solid must reach as far beyond every centre
///                 that will be asked for, and four voxels more.
/// Cost: about 0.3 us per voxel of the window and core. The solid is not needed afterwards.
[[nodiscard]] DistanceField make_field(const geom::VoxelSolid& solid, Real largest,
                                       const Vec3& corner = {});

/// One touch per local minimum of |x - centre| over the surface; shares as in share_force.
///
/// Curvature is reported as 0: pixels do not know it (their noise is of the order of 1/(8 voxels)),
/// so that a grain is a plane to Hertz's law; for grains of 8 d the force at given overlap is then
/// 6 % high. Sets `inside` when the centre is in a grain, `uncovered` when the sphere reaches beyond
/// the window, `lost` when it meets the grain but no minimum was found.
/// Tests: unit/dem_surface_field, verification/grain_contact.
void find_touches(const DistanceField& field, const Vec3& centre, Real radius, Real reach,
                  TouchList& out);

}  // namespace porefines::dem
