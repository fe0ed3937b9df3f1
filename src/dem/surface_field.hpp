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

  /// Per voxel: every point in it is at least clearance / 4 voxels away from the surface and from
  /// what the window does not know. Zero inside grains.
  std::vector<std::uint8_t> clearance;
};

/// @param largest  [m] radius + reach of the largest sphere: beyond that from every surface a query
///                 costs one load. The window of the solid must reach as far beyond every centre
///                 that will be asked for, and four voxels more.
/// Cost: about 0.2 us per voxel of the window and core. The solid is not needed afterwards.
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

/// Coordinates of SurfaceSpline.
[[nodiscard]] inline Vec3 to_voxels(const DistanceField& field, const Vec3& centre, Real scale) {
  const Vec3 x = scale * (centre - field.corner) - Vec3{0.5, 0.5, 0.5};
  return {x.x, x.y, field.spline.flat ? 0 : x.z};
}

/// False when a sphere is certain to touch nothing: one load.
/// @param x  [voxels] centre;  @param within  [voxels] radius + reach
[[nodiscard]] inline bool may_touch(const DistanceField& field, const Vec3& x, Real within) {
  const geom::Window& window = field.spline.window;
  const auto i = static_cast<int>(x.x + 0.5 - window.first[0]);
  const auto j = static_cast<int>(x.y + 0.5 - window.first[1]);
  const auto k = static_cast<int>(x.z + 0.5 - window.first[2]);
  const Int3 n = window.size();
  if (static_cast<unsigned>(i) >= static_cast<unsigned>(n[0]) ||
      static_cast<unsigned>(j) >= static_cast<unsigned>(n[1]) ||
      static_cast<unsigned>(k) >= static_cast<unsigned>(n[2])) {
    return true;
  }
  return field.clearance[static_cast<std::size_t>(geom::voxel_index(n, i, j, k))] <= 4 * within;
}

}  // namespace porefines::dem
