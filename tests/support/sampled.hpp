// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <algorithm>
#include <functional>

#include "geom/voxel_solid.hpp"

namespace porefines::test {

using Distance = std::function<Real(const Vec3&)>;  ///< of a point, all in voxels

inline geom::Window around(const Int3& n, int margin) {
  const bool flat = n[2] == 1;
  return {{-margin, -margin, flat ? 0 : -margin},
          {n[0] + margin, n[1] + margin, flat ? 1 : n[2] + margin}};
}

/// A solid that knows the exact distance at its voxels: what contact does to it is then contact's.
inline geom::VoxelSolid sampled(const Int3& n, Real pixel, const Distance& distance) {
  constexpr Real band = 8;
  geom::VoxelSolid solid{n, pixel, {}, band * pixel, around(n, 0), {}, {}};
  for (int k = 0; k < n[2]; ++k) {
    for (int j = 0; j < n[1]; ++j) {
      for (int i = 0; i < n[0]; ++i) {
        const Real s = distance({i + 0.5, j + 0.5, k + 0.5});
        solid.s.push_back(static_cast<float>(std::clamp(s, -band, band)));
      }
    }
  }
  return solid;
}

/// The solid that porefines makes of the binary image of a shape, known `margin` voxels beyond it.
inline geom::VoxelSolid pictured(const Int3& n, Real pixel, const Distance& distance,
                                 int margin = 8) {
  geom::Voxels voxels = geom::make_voxels(n, 0);
  for (int k = 0; k < n[2]; ++k) {
    for (int j = 0; j < n[1]; ++j) {
      for (int i = 0; i < n[0]; ++i) {
        voxels.at(i, j, k) = distance({i + 0.5, j + 0.5, k + 0.5}) > 0 ? 1 : 0;
      }
    }
  }
  constexpr geom::Surroundings mirrored{geom::Beyond::mirror, geom::Beyond::mirror,
                                        geom::Beyond::mirror};
  return geom::smooth_solid(voxels.view(), pixel, mirrored, around(n, margin), {1, 8});
}

}  // namespace porefines::test
