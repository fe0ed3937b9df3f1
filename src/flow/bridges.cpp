// SPDX-License-Identifier: MPL-2.0
#include "flow/bridges.hpp"

#include <algorithm>
#include <cstdint>

namespace porefines::flow {

namespace {

constexpr std::int32_t outside = 0;  ///< order of the node that stands for all beyond the block

/// Depth-first search over the cells of a block, joined by open faces.
class BridgeSearch {
 public:
  BridgeSearch(Level& level, const Boundaries& boundaries, Friction& friction)
      : level_(level), friction_(friction), order_(level.block.size, 0), low_(level.block.size, 0) {
    for (int a = 0; a < 3; ++a) {
      wraps_[a] = boundaries.periodic(a) && level.block.n[a] == level.block.global[a];
    }
  }

  Index close_all() {
    const grid::Block& b = level_.block;
    for (int k = 0; k < b.n[2]; ++k) {
      for (int j = 0; j < b.n[1]; ++j) {
        for (int i = 0; i < b.n[0]; ++i) {
          if (order_[b.at(i, j, k)] == 0) {
            search_from({i, j, k});
          }
        }
      }
    }
    return closed_;
  }

 private:
  /// A cell on the way from the root: where it is, the face it was entered by, the next to look at.
  struct Step {
    Int3 cell;
    std::uint8_t
        entered;  ///< direction 2 axis + (1: high side) of the face to the cell before; 6: root
    std::uint8_t next;
  };

  /// The face itself, not its copy behind a periodic border.
  [[nodiscard]] std::ptrdiff_t face_of(const Int3& cell, int direction) const {
    const int a = direction / 2;
    Int3 face = cell;
    face[a] += direction % 2;
    face[a] = wraps_[a] && face[a] == level_.block.n[a] ? 0 : face[a];
    return level_.block.at(face[0], face[1], face[2]);
  }
  [[nodiscard]] bool is_open(const Int3& cell, int direction) const {
    return level_.inverse_diagonal[direction / 2][face_of(cell, direction)] != 0;
  }
  /// Moves to the cell behind a face; false where that lies outside the block.
  [[nodiscard]] bool step_to(Int3& cell, int direction) const {
    const int a = direction / 2;
    const int n = level_.block.n[a];
    cell[a] += direction % 2 == 0 ? -1 : 1;
    if (wraps_[a]) {
      cell[a] = (cell[a] + n) % n;
    }
    return cell[a] >= 0 && cell[a] < n;
  }
  void enter(const Int3& cell, int entered) {
    const std::ptrdiff_t at = level_.block.at(cell[0], cell[1], cell[2]);
    order_[at] = low_[at] = ++count_;
    path_.push_back({cell, static_cast<std::uint8_t>(entered), 0});
  }
  void search_from(const Int3& root) {
    enter(root, 6);
    while (!path_.empty()) {
      Step& here = path_.back();
      if (here.next == 6) {
        leave();
        continue;
      }
      const int direction = here.next++;
      if (direction != here.entered && is_open(here.cell, direction)) {
        look(here.cell, direction);
      }
    }
  }
  void look(const Int3& from, int direction) {
    std::int32_t& low = low_[level_.block.at(from[0], from[1], from[2])];
    Int3 cell = from;
    if (!step_to(cell, direction)) {
      low = outside;
      return;
    }
    const std::int32_t seen = order_[level_.block.at(cell[0], cell[1], cell[2])];
    if (seen != 0) {
      low = std::min(low, seen);
    } else {
      enter(cell, direction ^ 1);
    }
  }
  void leave() {
    const Step done = path_.back();
    path_.pop_back();
    if (path_.empty()) {
      return;
    }
    const Int3& before = path_.back().cell;
    const std::ptrdiff_t at = level_.block.at(done.cell[0], done.cell[1], done.cell[2]);
    const std::ptrdiff_t parent = level_.block.at(before[0], before[1], before[2]);
    low_[parent] = std::min(low_[parent], low_[at]);
    if (low_[at] > order_[parent]) {
      close(done.cell, done.entered);
    }
  }
  void close(const Int3& cell, int direction) {
    const int a = direction / 2;
    const std::ptrdiff_t face = face_of(cell, direction);
    level_.inverse_diagonal[a][face] = 0;
    friction_.excess[a][face] = Friction::inactive;
    ++closed_;
  }

  Level& level_;
  Friction& friction_;
  std::array<bool, 3> wraps_{};
  std::vector<std::int32_t> order_;  ///< when a cell was first seen, from 1; 0: not yet
  std::vector<std::int32_t> low_;    ///< earliest order that its subtree reaches by another way
  std::vector<Step> path_;
  std::int32_t count_ = 0;
  Index closed_ = 0;
};

}  // namespace

Index close_bridges(Level& level, const Boundaries& boundaries, Friction& friction) {
  return BridgeSearch(level, boundaries, friction).close_all();
}

}  // namespace porefines::flow
