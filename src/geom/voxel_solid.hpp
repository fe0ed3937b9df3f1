// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <vector>

#include "core/types.hpp"
#include "geom/voxels.hpp"

namespace porefines::geom {

/// A box of voxels {first, past last}; it may reach beyond the image.
struct Window {
  Int3 first{0, 0, 0};
  Int3 past{0, 0, 0};

  [[nodiscard]] Int3 size() const {
    return {past[0] - first[0], past[1] - first[1], past[2] - first[2]};
  }
  [[nodiscard]] bool holds(int i, int j, int k) const {
    return i >= first[0] && i < past[0] && j >= first[1] && j < past[1] && k >= first[2] &&
           k < past[2];
  }
};

struct Smoothing {
  Real sigma = 1;  ///< [pixels] standard deviation of the Gaussian, 0.5..20
  Real band = 8;   ///< [pixels] distances are true up to here and saturate beyond, 2..400
};

/// What smoothing did to the voxels of the window that lie inside the image.
struct SmoothingReport {
  Index flipped_pores = 0;   ///< pore voxels whose centre ended up in a grain (rounded corners)
  Index flipped_grains = 0;  ///< grain voxels whose centre ended up in the pore
  Index rescued = 0;         ///< voxels kept although the Gaussian would have closed a throat
                             ///< or erased a grain there
};

/// Smooth signed distance of a binary image in a window of it.
///
/// Near the surface it is the distance that a plane would have after the blur
///
///     phi = Gaussian_sigma * pore,   r = sigma sqrt(2) erfinv(2 phi - 1),
///     s   = r / |grad r| - sigma^2/2 div(grad r / |grad r|)
///
/// (the last term undoes the shrinkage of curved surfaces, to first order in sigma^2 curvature).
/// Further away s is the distance to the tangent plane at the foot point, found from the nearest
/// surface voxel by a Newton step; beyond `band` it saturates at +-band with the right sign.
/// A voxel that the blur would flip keeps its phase where the flip would close a throat, cut a
/// grain or erase one (it is not simple in its 3x3x3 neighbourhood, or no like voxel is left).
///
/// The value at a voxel depends on the image alone and not on the window, bitwise.
/// Tests: unit/geom_voxel_solid (discs, spheres, planes, throats, windows).
struct VoxelSolid {
  Int3 n{0, 0, 0};  ///< voxels of the image; n[2] = 1: extruded along z
  Real pixel = 1;   ///< [m]
  Surroundings beyond{};
  Real band = 0;         ///< [m]
  Window window;         ///< for a 2D image window.first[2] = 0, past[2] = 1
  std::vector<float> s;  ///< [pixels] at the voxel centres of the window
  SmoothingReport report;
};

/// Build the distance in `window`. Cost: about 0.1 us per voxel and core; memory while building
/// about 20 bytes per voxel of the window grown by band + 4 sigma + 4.
[[nodiscard]] VoxelSolid smooth_solid(const VoxelView& image, Real pixel,
                                      const Surroundings& beyond, Window window,
                                      const Smoothing& smoothing);

/// Distance at any point by trilinear interpolation [m].
///
/// Points outside the window are first looked for on the other side of periodic faces and of
/// mirrors; what is then still outside takes the nearest value of the window.
[[nodiscard]] Real signed_distance(const VoxelSolid& solid, const Vec3& x);

}  // namespace porefines::geom
