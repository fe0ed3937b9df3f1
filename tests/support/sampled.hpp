// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <algorithm>
#include <functional>

#include "geom/segment.hpp"
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

constexpr geom::Surroundings mirrored_beyond{geom::Beyond::mirror, geom::Beyond::mirror,
                                             geom::Beyond::mirror};

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
  return geom::smooth_solid(voxels.view(), pixel, mirrored_beyond, around(n, margin), {1, 8});
}

/// And of a grey one, in which a pixel is as bright as much of it is pore; flat.
inline geom::VoxelSolid photographed(const Int3& n, Real pixel, const Distance& distance,
                                     int margin = 8) {
  constexpr int points = 10;  // a side
  geom::GreyVolume image{n, {}};
  for (int j = 0; j < n[1]; ++j) {
    for (int i = 0; i < n[0]; ++i) {
      int pore = 0;
      for (int p = 0; p < points * points; ++p) {
        const Vec3 x{i + (p % points + 0.5) / points, j + (p / points + 0.5) / points, 0};
        pore += distance(x) > 0 ? 1 : 0;
      }
      image.grey.push_back(static_cast<std::uint8_t>(30 + 2 * pore));
    }
  }
  geom::Segmentation how;
  how.otsu = true;
  const geom::Voxels voxels = geom::segment(std::move(image), how, "photograph");
  return geom::smooth_solid(voxels.view(), pixel, mirrored_beyond, around(n, margin), {1, 8});
}

}  // namespace porefines::test
