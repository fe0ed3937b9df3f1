// SPDX-License-Identifier: MPL-2.0
#include "flow/bridges.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace porefines::flow {

namespace {

constexpr std::int32_t outside = 0;  ///< order of the node that stands for all beyond the block

/// Depth-first search over the cells of a block, joined by open faces. Directions are 2 axis + (1: to
/// the high side); cells are places in memory.
class BridgeSearch {
 public:
  BridgeSearch(Level& level, const Boundaries& boundaries, Friction& friction)
      : level_(level), friction_(friction), open_(level.block.size, 0), mark_(level.block.size) {
    const grid::Block& b = level.block;
    for (int a = 0; a < 3; ++a) {
      wraps_[a] = boundaries.periodic(a) && b.n[a] == b.global[a];
    }
    for_cells([&](const Int3& cell, std::int32_t at) {
      std::uint8_t bits = 0;
      for (int a = 0; a < 3; ++a) {
        const bool high = level.inverse_diagonal[a][face_of(cell, 2 * a + 1)] != 0;
        bits |= (level.inverse_diagonal[a][at] != 0 ? 1 : 0) << (2 * a) | (high ? 2 : 0) << (2 * a);
        bits |= cell[a] == 0 || cell[a] + 1 == b.n[a] ? at_border : 0;
      }
      open_[at] = bits;
    });
  }

  Index close_all() {
    for_cells([&](const Int3&, std::int32_t at) {
      if (mark_[at].order == 0) {
        search_from(at);
      }
    });
    return closed_;
  }

 private:
  static constexpr int nowhere = 6;
  static constexpr std::uint8_t at_border = 64;  ///< the cell beyond may be elsewhere, or outside
  static constexpr std::uint8_t directions = 63;

  struct Mark {
    std::int32_t order = 0;  ///< when the cell was first seen, from 1; 0: not yet
    std::int32_t low = 0;    ///< earliest order that its subtree reaches by another way
  };
  /// A cell on the way from the root.
  struct Step {
    std::int32_t at;
    std::uint8_t entered;  ///< direction of the face to the cell before; nowhere at the root
    std::uint8_t left;     ///< bits of the open directions still to look at
  };

  template <typename Visit>
  void for_cells(const Visit& visit) const {
    const grid::Block& b = level_.block;
    for (int k = 0; k < b.n[2]; ++k) {
      for (int j = 0; j < b.n[1]; ++j) {
        for (int i = 0; i < b.n[0]; ++i) {
          visit(Int3{i, j, k}, static_cast<std::int32_t>(b.at(i, j, k)));
        }
      }
    }
  }
  [[nodiscard]] std::ptrdiff_t face_of(const Int3& cell, int direction) const {
    const int a = direction / 2;
    Int3 face = cell;
    face[a] += direction % 2;
    face[a] = wraps_[a] && face[a] == level_.block.n[a] ? 0 : face[a];
    return level_.block.at(face[0], face[1], face[2]);
  }
  /// The cell behind a face; -1 where that lies outside the block.
  [[nodiscard]] std::int32_t behind(std::int32_t at, int direction) const {
    const grid::Block& b = level_.block;
    const int a = direction / 2;
    const int ahead = direction % 2 == 0 ? -1 : 1;
    if ((open_[at] & at_border) == 0) {
      return at + ahead * static_cast<std::int32_t>(b.stride(a));
    }
    Int3 cell = level_.block.index_of(at);
    cell[a] += ahead;
    if (wraps_[a]) {
      cell[a] = (cell[a] + b.n[a]) % b.n[a];
    }
    const bool inside = cell[a] >= 0 && cell[a] < b.n[a];
    return inside ? static_cast<std::int32_t>(b.at(cell[0], cell[1], cell[2])) : -1;
  }
  void enter(std::int32_t at, int entered) {
    mark_[at].order = mark_[at].low = ++count_;
    const int left = open_[at] & directions & ~(1 << entered);
    path_.push_back({at, static_cast<std::uint8_t>(entered), static_cast<std::uint8_t>(left)});
  }
  void search_from(std::int32_t root) {
    enter(root, nowhere);
    while (!path_.empty()) {
      Step& here = path_.back();
      if (here.left == 0) {
        leave();
        continue;
      }
      const int direction = std::countr_zero(here.left);
      here.left &= static_cast<std::uint8_t>(here.left - 1);
      look(here.at, direction);
    }
  }
  void look(std::int32_t from, int direction) {
    const std::int32_t at = behind(from, direction);
    std::int32_t& low = mark_[from].low;
    if (at < 0) {
      low = outside;
    } else if (mark_[at].order != 0) {
      low = std::min(low, mark_[at].order);
    } else {
      enter(at, direction ^ 1);
    }
  }
  void leave() {
    const Step done = path_.back();
    path_.pop_back();
    if (path_.empty()) {
      return;
    }
    Mark& before = mark_[path_.back().at];
    before.low = std::min(before.low, mark_[done.at].low);
    if (mark_[done.at].low > before.order) {
      close(level_.block.index_of(done.at), done.entered);
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
  std::vector<std::uint8_t> open_;  ///< bits of the open directions, and at_border
  std::vector<Mark> mark_;
  std::vector<Step> path_;
  std::int32_t count_ = 0;
  Index closed_ = 0;
};

}  // namespace

Index close_bridges(Level& level, const Boundaries& boundaries, Friction& friction) {
  return BridgeSearch(level, boundaries, friction).close_all();
}

}  // namespace porefines::flow
