// SPDX-License-Identifier: MPL-2.0
#include "traffic.hpp"

namespace porefines::bench {
namespace {

constexpr double word = sizeof(float);

double visit_bytes(flow::Hierarchy& hierarchy, int l, bool first) {
  const flow::Level& level = hierarchy.level(l);
  const auto cells = static_cast<double>(active_cells(level));
  double bytes = first ? 4 * word * cells : 0;
  if (l + 1 == hierarchy.size()) {
    return bytes + 20 * sweep_bytes(level);
  }
  const auto coarse = static_cast<double>(active_cells(hierarchy.level(l + 1)));
  bytes += 4 * sweep_bytes(level);
  bytes += (level.weighted() ? 22 : 19) * word * cells;
  bytes += word * (4 * cells + 13 * coarse);
  bytes += word * (12 * cells + 13 * coarse);
  return bytes + visit_bytes(hierarchy, l + 1, true) +
         (l >= 1 ? visit_bytes(hierarchy, l + 1, false) : 0);
}

}  // namespace

Index active_cells(const flow::Level& level) {
  const grid::Block& b = level.block;
  Index lines = 0;
  for (int k = 0; k < b.n[2]; ++k) {
    for (int j = 0; j < b.n[1]; ++j) {
      flow::for_lines(level, j, k,
                      [&](int i) { lines += i + grid::line_width > 0 && i < b.n[0] ? 1 : 0; });
    }
  }
  return lines * grid::line_width;
}

double sweep_bytes(const flow::Level& level) {
  return (level.weighted() ? 19 : 16) * word * static_cast<double>(active_cells(level));
}

double cycle_bytes(flow::Hierarchy& hierarchy) {
  return visit_bytes(hierarchy, 0, true);
}

}  // namespace porefines::bench
