// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dem/surface_spline.hpp"

namespace porefines::dem {

/// Points of the surface s = 0, about one per surface voxel and never two voxels apart, in bins.
///
/// Coordinates as in SurfaceSpline. Bins are aligned with the image and their content depends on
/// the image alone (away from the border of the window).
struct SurfacePoints {
  static constexpr int edge = 4;  ///< [voxels] of a bin

  struct Shape {
    std::array<float, 3> normal;  ///< unit, into the pore
    float bend;                   ///< [1/voxel] largest curvature towards the pore, 0..4
  };

  Int3 first_bin{0, 0, 0};
  Int3 bins{0, 0, 0};
  std::vector<std::int32_t> start;  ///< per bin, and one more
  std::vector<float> x, y, z;
  std::vector<Shape> shape;

  /// Calls visit(p) for the points within `distance` of c.
  template <class Visit>
  void for_each_near(const Vec3& c, Real distance, const Visit& visit) const {
    Int3 low{};
    Int3 high{};
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      low[a] = std::max(bin_of(c[axis] - distance) - first_bin[a], 0);
      high[a] = std::min(bin_of(c[axis] + distance) - first_bin[a], bins[a] - 1);
    }
    const auto cx = static_cast<float>(c.x);
    const auto cy = static_cast<float>(c.y);
    const auto cz = static_cast<float>(c.z);
    const auto most = static_cast<float>(distance * distance);
    for (int k = low[2]; k <= high[2]; ++k) {
      for (int j = low[1]; j <= high[1] && low[0] <= high[0]; ++j) {
        const auto row = static_cast<std::size_t>(geom::voxel_index(bins, 0, j, k));
        const auto past = start[row + static_cast<std::size_t>(high[0]) + 1];
        for (auto p = static_cast<std::size_t>(start[row + static_cast<std::size_t>(low[0])]);
             p < static_cast<std::size_t>(past); ++p) {
          const float dx = x[p] - cx;
          const float dy = y[p] - cy;
          const float dz = z[p] - cz;
          if (dx * dx + dy * dy + dz * dz < most) {
            visit(p);
          }
        }
      }
    }
  }

  static int bin_of(Real at) { return static_cast<int>(std::floor((at + 0.5) / edge)); }
};

/// Newton steps from every voxel centre near the surface; 1 us per surface voxel.
[[nodiscard]] SurfacePoints find_points(const SurfaceSpline& spline);

/// Curvatures of the level surface at a point: normal, and the shape operator
/// S = P hess(s) P / |grad s| in the tangent directions u, v.
struct Bending {
  Real slope = 0;  ///< |grad s|
  Vec3 n, u, v;
  Real uu = 0, uv = 0, vv = 0;
};
[[nodiscard]] Bending bending(const Jet& jet);

}  // namespace porefines::dem
