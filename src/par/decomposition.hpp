// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/types.hpp"

namespace porefines::par {

/// How a box of cells is cut into one Cartesian block per rank.
///
/// Rank r has coordinates (r % px, (r / px) % py, r / (px py)). Along each axis block b holds the
/// cells [cuts[b], cuts[b+1]). Inner cuts are multiples of `alignment`, so that blocks stay blocks
/// on every coarse grid that is spread over the ranks.
struct Decomposition {
  Int3 cells{1, 1, 1};
  Int3 ranks{1, 1, 1};
  std::array<std::vector<int>, 3> cuts;
  int alignment = 1;

  [[nodiscard]] Int3 coordinates(int rank) const;
  [[nodiscard]] int rank_at(const Int3& coordinates) const;
  [[nodiscard]] Int3 start(int rank) const;
  [[nodiscard]] Int3 extent(int rank) const;

  /// The same cuts on the grid that is coarser by 2 along these axes, where they have more than one
  /// cell.
  [[nodiscard]] Decomposition coarsened(const std::array<bool, 3>& halved = {true, true,
                                                                             true}) const;
};

/// Number of fluid cells in every layer normal to an axis: what the cuts balance.
using LayerWork = std::array<std::vector<Real>, 3>;

/// Smallest number of cells of a block along an axis that is cut: ghosts must fit inside.
inline constexpr int smallest_block = 8;

/// Cuts a box for `size` ranks so that the work per block is even and the surface small.
///
/// Prefers cuts along z, then y, then x, since memory runs along x. Every block keeps at least
/// `smallest_block` cells on cut axes.
/// @param forced  ranks along x, y, z given by the user
/// @throws InputError when the box is too small for that many ranks, naming the largest number
Decomposition decompose(const Int3& cells, int size, const LayerWork& work,
                        const std::optional<Int3>& forced = std::nullopt);

}  // namespace porefines::par
