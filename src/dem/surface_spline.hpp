// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <vector>

#include "geom/voxel_solid.hpp"

namespace porefines::dem {

/// Value, gradient and second derivatives of a field at a point.
struct Jet {
  Real f = 0;
  Vec3 g;
  Real xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
};

/// Twice continuously differentiable interpolant of a sampled signed distance, in voxels: the
/// centre of voxel i stands at coordinate i.
///
///     s(x) = sum_ijk c_ijk B(x - i) B(y - j) B(z - k),   c = s - (dxx + dyy + dzz) s / 6
///
/// with the cubic B-spline B and central second differences: fourth order, and local, so that the
/// value does not depend on the window. It damps noise between neighbouring voxels to a half.
/// A 2D image (one voxel along z) is constant along z.
/// Test: unit/dem_surface_field (order of convergence, derivatives).
struct SurfaceSpline {
  geom::Window window;   ///< of c: the window of the solid without its outermost layer
  bool flat = false;     ///< one voxel along z
  std::vector<float> c;  ///< [voxels]

  [[nodiscard]] Jet jet(const Vec3& x) const;

  /// Nearest coefficient: s within about half a voxel.
  [[nodiscard]] float coefficient(int i, int j, int k) const {
    const Int3 n = window.size();
    return c[static_cast<std::size_t>(
        geom::voxel_index(n, i - window.first[0], j - window.first[1], k - window.first[2]))];
  }
};

[[nodiscard]] SurfaceSpline make_spline(const geom::VoxelSolid& solid);

}  // namespace porefines::dem
