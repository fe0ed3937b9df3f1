// SPDX-License-Identifier: MPL-2.0
// SphereCover: small pockets between spheres.
#include <algorithm>
#include <cmath>

#include "flow/sphere_cover.hpp"

namespace porefines::flow {

namespace {

constexpr int widest = 4;           ///< cells a side of what counts as a pocket
constexpr std::uint8_t wide = 1;    ///< part of something wider
constexpr std::uint8_t narrow = 2;  ///< part of a pocket

}  // namespace

/// What lies behind an open face of a cell. @return false beyond the box or what this rank sees
bool SphereCover::step_through(Int3& cell, int axis, int side) const {
  cell[axis] += side == 0 ? -1 : 1;
  const int total = cell[axis] + level_.block.start[axis];
  return is_inside(cell) &&
         (boundaries_.periodic(axis) || (total >= 0 && total < level_.block.global[axis]));
}

/// Flood from a cell through open faces; gives up where it grows wider than a pocket.
SphereCover::Flood SphereCover::flood_from(std::uint32_t start) const {
  const grid::Block& b = level_.block;
  Flood flood;
  flood.cells.push_back(start);
  Int3 low = index_of(start);
  Int3 high = low;
  for (std::size_t next = 0; next < flood.cells.size(); ++next) {
    const std::uint32_t from = flood.cells[next];
    for (int direction = 0; direction < 6; ++direction) {
      const int a = direction / 2;
      const int side = direction % 2;
      const std::ptrdiff_t face = from + side * b.stride(a);
      if (level_.inverse_diagonal[a][face] == 0) {
        continue;
      }
      flood.faces.emplace_back(a, static_cast<std::uint32_t>(face));
      Int3 q = index_of(from);
      if (!step_through(q, a, side)) {
        return flood;
      }
      const auto there = static_cast<std::uint32_t>(b.at(q[0], q[1], q[2]));
      if (std::find(flood.cells.begin(), flood.cells.end(), there) == flood.cells.end()) {
        flood.cells.push_back(there);
      }
      low[a] = std::min(low[a], q[a]);
      high[a] = std::max(high[a], q[a]);
      if (high[a] - low[a] >= widest || mark_[there] == wide) {
        return flood;
      }
    }
  }
  flood.closed = true;
  return flood;
}

int SphereCover::nearest_image(const SphereSet& set, int component, std::uint32_t face) const {
  int nearest = 0;
  Real best = INFINITY;
  for (std::size_t image = 0; image < set.images().size(); ++image) {
    const BallImage& q = set.images()[image];
    const Real gap = norm(arm_of(component, index_of(face), q.centre)) - set.balls()[q.ball].radius;
    if (gap < best) {
      best = gap;
      nearest = static_cast<int>(image);
    }
  }
  return nearest;
}

/// From every cell with a covered face.
void SphereCover::close_pockets(const SphereSet& set) {
  mark_.assign(level_.block.size, 0);
  for (const std::uint32_t start : changed_cells()) {
    if (mark_[start] != 0) {
      continue;
    }
    const Flood flood = flood_from(start);
    for (const std::uint32_t at : flood.cells) {
      mark_[at] = flood.closed ? narrow : wide;
    }
    if (!flood.closed || flood.faces.empty()) {
      continue;
    }
    ++count_.pockets;
    for (const auto& [a, at] : flood.faces) {
      if (level_.inverse_diagonal[a][at] != 0) {  // not yet: each is seen from both sides
        take_face(a, at, nearest_image(set, a, at));
      }
    }
  }
}

}  // namespace porefines::flow
