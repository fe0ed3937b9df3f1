// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geom/voxels.hpp"

namespace porefines::geom {

/// The pore, thinned to `anchor` and the lines (in 3D also shells around floating grains) that its
/// topology needs: simple points are removed, the lowest depth first.
///
/// @param depth   per voxel: its order, such as the squared distance to the grain; >= 0
/// @param anchor  per voxel: nonzero stays
/// @return        per voxel: 1 = left
/// Periodic faces are neighbours; beyond other faces there is no pore.
[[nodiscard]] std::vector<std::uint8_t> thin(const VoxelView& image, const Surroundings& beyond,
                                             const std::vector<int>& depth,
                                             const std::vector<std::uint8_t>& anchor);

/// Column, row and plane of a place in the flat array.
[[nodiscard]] inline Int3 position(const Int3& n, Index v) {
  return {static_cast<int>(v % n[0]), static_cast<int>(v / n[0] % n[1]),
          static_cast<int>(v / (Index{n[0]} * n[1]))};
}

}  // namespace porefines::geom
