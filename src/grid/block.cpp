// SPDX-License-Identifier: MPL-2.0
#include "grid/block.hpp"

namespace porefines::grid {

Block make_block(const par::Decomposition& decomposition, int rank,
                 const std::array<bool, 3>& periodic, int ghost_depth) {
  Block b;
  b.global = decomposition.cells;
  b.start = decomposition.start(rank);
  b.n = decomposition.extent(rank);
  for (int a = 0; a < 3; ++a) {
    const bool cut = decomposition.ranks[a] > 1;
    b.ghost[a] = cut || periodic[a] ? ghost_depth : 1;
    b.owns_end[a] = !periodic[a] && b.start[a] + b.n[a] == b.global[a];
  }
  const auto length = [&b](int a) { return std::ptrdiff_t{b.n[a]} + 2 * b.ghost[a] + 1; };
  b.sy = (length(0) + line_width - 1) / line_width * line_width;
  b.sz = b.sy * length(1);
  b.origin = line_width + b.ghost[0] + b.sy * b.ghost[1] + b.sz * b.ghost[2];
  b.size = static_cast<std::size_t>(b.sz * length(2) + 2 * line_width);
  return b;
}

}  // namespace porefines::grid
