// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <vector>

#include "core/types.hpp"
#include "par/decomposition.hpp"

namespace porefines::dem {

/// The region that particles live in. Across a periodic axis they leave at one side and enter at the
/// other; across the other axes nothing holds them but walls: what is outside is the caller's to take.
struct Box {
  Vec3 low;   ///< [m]
  Vec3 high;  ///< [m]
  std::array<bool, 3> periodic{};

  [[nodiscard]] Real length(int axis) const { return high[axis] - low[axis]; }
  /// The same place inside the box, on periodic axes.
  [[nodiscard]] Vec3 wrapped(Vec3 x) const;
};

/// The box cut into one block per rank by planes; ranks are numbered as in par::Decomposition.
struct Blocks {
  Int3 ranks{1, 1, 1};
  std::array<std::vector<Real>, 3> cuts;  ///< [m] ranks[a] + 1 planes along axis a

  /// The rank whose block holds a place; places outside the box belong to the nearest block.
  [[nodiscard]] int owner(const Vec3& place) const;
  [[nodiscard]] Int3 coordinates(int rank) const;
  [[nodiscard]] int rank_at(const Int3& coordinates) const;
};

/// The blocks of the flow's decomposition, whose cells fill the box evenly.
[[nodiscard]] Blocks make_blocks(const par::Decomposition& decomposition, const Box& box);

/// Equal blocks for a run without a grid: as near to cubes as `ranks` allows, cuts along z first. What
/// falls ends on one side: a cut across `gravity` must save half of the surface to be worth it.
[[nodiscard]] Blocks even_blocks(const Box& box, int ranks, const Vec3& gravity = {});

}  // namespace porefines::dem
