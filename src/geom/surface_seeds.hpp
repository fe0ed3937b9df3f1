// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/types.hpp"
#include "geom/voxel_solid.hpp"

namespace porefines::geom {

/// Tangent plane of the smooth surface near a voxel: distance and unit normal into the pore.
///
/// Normal zero: a rescued voxel without a plane of its own (midway in a channel one pixel wide, a
/// grain of one pixel); it counts as a ball of diameter one, pore when s > 0.
struct Seed {
  float s;  ///< [pixels] signed distance of the voxel centre
  std::array<float, 3> normal;
};

/// The smooth surface of a window, before distances are carried away from it.
struct SurfaceSeeds {
  Window window;                    ///< where seeds were looked for
  std::vector<std::int32_t> index;  ///< per voxel: place in `seed`, or -1
  std::vector<std::uint8_t> mark;   ///< per voxel: 1 where there is a seed
  std::vector<Seed> seed;
  std::vector<std::int8_t> side;  ///< per voxel: +1 pore, -1 grain, after smoothing
  Index rescued = 0;              ///< inside `count_in` and the image

  [[nodiscard]] std::size_t at(int i, int j, int k) const {
    const Int3 n = window.size();
    return static_cast<std::size_t>(
        i - window.first[0] +
        Index{n[0]} * (j - window.first[1] + Index{n[1]} * (k - window.first[2])));
  }
};

/// Blur, invert the error function, rescue, correct for curvature (formulas at VoxelSolid).
[[nodiscard]] SurfaceSeeds find_surface(const VoxelView& image, const Surroundings& beyond,
                                        const Window& window, const Window& count_in, Real sigma);

/// The window grown by `by` voxels on each side; not along z when flat.
[[nodiscard]] Window grown(const Window& window, int by, bool flat);

}  // namespace porefines::geom
