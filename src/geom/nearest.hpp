// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/types.hpp"

namespace porefines::geom {

/// Offset in voxels from a voxel to its nearest marked voxel.
struct Offset {
  static constexpr std::int16_t nothing = INT16_MIN;  ///< dx when no mark is within reach
  std::int16_t dx = nothing;
  std::int16_t dy = 0;
  std::int16_t dz = 0;
};

/// One finished row (all i) of the transform below at (j, k).
using VisitRow = std::function<void(int j, int k, const std::vector<Offset>& row)>;

/// Exact Euclidean nearest-mark transform, as far as `reach` voxels along every axis.
///
///     key(x) = min over marks q of (|x - q|^2, q - x),   compared lexicographically
///
/// by three separable passes (Felzenszwalb & Huttenlocher 2012 state the separability; here each
/// pass is a direct minimum over 2 reach + 1 neighbours, which vectorises). Ties are broken by
/// the offset, so the answer depends on the neighbourhood alone and not on the window.
///
/// @param mark   nonzero = marked; size n: the target grown by `reach` on each side (x, y, and z
///               unless n[2] = 1)
/// @param reach  1..500
/// Test: unit/geom_nearest (brute force).
void for_each_nearest(const std::vector<std::uint8_t>& mark, const Int3& n, int reach,
                      const VisitRow& visit);

}  // namespace porefines::geom
