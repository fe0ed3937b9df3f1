// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/types.hpp"

namespace porefines::geom {

/// Full scale of a blurred share: 32768 stands for 1.
inline constexpr int blur_one = 1 << 15;

/// Weights w_k, k = -r..r, of a Gaussian of standard deviation sigma [pixels], as integers with
/// sum blur_one; r = ceil(4 sigma). Integers make the sum the same in any order, and so the
/// blurred value the same in any window.
[[nodiscard]] std::vector<int> gaussian_weights(Real sigma);

/// Convolve a volume of 0..full_share (voxels.hpp) with the Gaussian along x, y and (unless n[2] = 1) z.
///
/// The result is smaller by r on each side of each blurred axis: only complete sums are kept.
/// @param n        size of the share; on return the size of the result
/// @return         phi in 0..blur_one
/// Cost: 3 (2r + 1) integer multiply-adds per voxel, vectorised along x.
[[nodiscard]] std::vector<std::uint16_t> blur(const std::vector<std::uint8_t>& share, Int3& n,
                                              const std::vector<int>& weights);

}  // namespace porefines::geom
