// SPDX-License-Identifier: MPL-2.0
#include "geom/components.hpp"

#include <numeric>

namespace porefines::geom {

namespace {

/// Union-find that also knows how many periods lie between an element and its root.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count), shift_(count, 0), wraps_(count, 0) {
    std::iota(parent_.begin(), parent_.end(), std::int32_t{0});
  }

  std::int32_t find(std::int32_t a) {
    std::int32_t root = a;
    std::int32_t total = 0;
    while (parent_[at(root)] != root) {
      total += shift_[at(root)];
      root = parent_[at(root)];
    }
    while (parent_[at(a)] != root && a != root) {  // compress
      const std::int32_t next = parent_[at(a)];
      const std::int32_t step = shift_[at(a)];
      parent_[at(a)] = root;
      shift_[at(a)] = total;
      total -= step;
      a = next;
    }
    return root;
  }

  /// a and b are neighbours; going from a to b crosses the periodic face `crossing` times.
  void join(std::int32_t a, std::int32_t b, std::int32_t crossing) {
    const std::int32_t ra = find(a);
    const std::int32_t rb = find(b);
    const std::int32_t between = shift_of(a) + crossing - shift_of(b);
    if (ra == rb) {
      wraps_[at(ra)] |= between != 0 ? 1 : 0;
      return;
    }
    parent_[at(rb)] = ra;
    shift_[at(rb)] = between;
    wraps_[at(ra)] |= wraps_[at(rb)];
  }

  [[nodiscard]] bool wraps(std::int32_t root) const { return wraps_[at(root)] != 0; }

 private:
  static std::size_t at(std::int32_t a) { return static_cast<std::size_t>(a); }
  [[nodiscard]] std::int32_t shift_of(std::int32_t a) const {
    return parent_[at(a)] == a ? 0 : shift_[at(a)];
  }
  std::vector<std::int32_t> parent_;
  std::vector<std::int32_t> shift_;  ///< periods from the parent to the element
  std::vector<std::uint8_t> wraps_;
};

using Run = Components::Run;

Components find_runs(const VoxelView& voxels, Phase phase) {
  Components out;
  const std::uint8_t wanted = phase == Phase::pore ? 1 : 0;
  const Index rows = Index{voxels.n[1]} * voxels.n[2];
  for (Index row = 0; row < rows; ++row) {
    out.row.push_back(out.run.size());
    const std::uint8_t* v = voxels.pore + row * voxels.n[0];
    for (int x = 0; x < voxels.n[0];) {
      if (v[x] != wanted) {
        ++x;
        continue;
      }
      const int first = x;
      while (x < voxels.n[0] && v[x] == wanted) {
        ++x;
      }
      out.run.push_back({first, x, 0});
    }
  }
  out.row.push_back(out.run.size());
  return out;
}

struct Rules {
  bool diagonal;  ///< neighbours through edges and corners
  std::array<bool, 3> periodic;
  int axis;
};

/// Join the runs of row a with those of row b; the way from a to b crosses the face `crossing`
/// times (already restricted to the axis of interest).
void join_rows(const Components& c, std::size_t a, std::size_t b, int crossing, int nx,
               const Rules& rules, Sets& sets) {
  const int reach = rules.diagonal ? 1 : 0;
  const std::size_t b_end = c.row[b + 1];
  std::size_t start = c.row[b];
  for (std::size_t i = c.row[a]; i < c.row[a + 1]; ++i) {
    const Run& run = c.run[i];
    while (start < b_end && c.run[start].past + reach <= run.first) {
      ++start;
    }
    for (std::size_t k = start; k < b_end && c.run[k].first < run.past + reach; ++k) {
      sets.join(static_cast<std::int32_t>(i), static_cast<std::int32_t>(k), crossing);
    }
  }
  if (rules.periodic[0] && rules.diagonal && c.row[a] < c.row[a + 1] && c.row[b] < b_end) {
    const int step = rules.axis == 0 ? 1 : 0;  // corners across the periodic x faces
    const std::size_t a_last = c.row[a + 1] - 1;
    if (c.run[a_last].past == nx && c.run[c.row[b]].first == 0) {
      sets.join(static_cast<std::int32_t>(a_last), static_cast<std::int32_t>(c.row[b]),
                crossing + step);
    }
    if (c.run[c.row[a]].first == 0 && c.run[b_end - 1].past == nx) {
      sets.join(static_cast<std::int32_t>(c.row[a]), static_cast<std::int32_t>(b_end - 1),
                crossing - step);
    }
  }
}

/// Row next to (j, k) in the direction (dj, dk), through periodic faces; false when there is none.
bool next_row(const Int3& n, const Rules& rules, std::array<int, 2> from, std::array<int, 2> way,
              std::size_t& row, int& crossing) {
  std::array<int, 2> to{from[0] + way[0], from[1] + way[1]};
  crossing = 0;
  for (std::size_t t = 0; t < 2; ++t) {
    const int size = n[t + 1];
    if (to[t] >= 0 && to[t] < size) {
      continue;
    }
    if (!rules.periodic[t + 1] || (t == 1 && size == 1)) {
      return false;
    }
    crossing += rules.axis == static_cast<int>(t) + 1 ? way[t] : 0;
    to[t] = (to[t] + size) % size;
  }
  row = static_cast<std::size_t>(to[0]) + static_cast<std::size_t>(n[1]) * to[1];
  return true;
}

void join_all(const Components& c, const Int3& n, const Rules& rules, Sets& sets) {
  // the neighbour rows on one side: (dj, dk)
  std::vector<std::array<int, 2>> ways{{1, 0}, {0, 1}};
  if (rules.diagonal) {
    ways.push_back({1, 1});
    ways.push_back({-1, 1});
  }
  for (std::size_t a = 0; a + 1 < c.row.size(); ++a) {
    const std::size_t first = c.row[a];
    const std::size_t past = c.row[a + 1];
    if (rules.periodic[0] && first < past && c.run[first].first == 0 &&
        c.run[past - 1].past == n[0]) {
      sets.join(static_cast<std::int32_t>(past - 1), static_cast<std::int32_t>(first),
                rules.axis == 0 ? 1 : 0);
    }
    const std::array<int, 2> here{static_cast<int>(a % static_cast<std::size_t>(n[1])),
                                  static_cast<int>(a / static_cast<std::size_t>(n[1]))};
    for (const auto& way : ways) {
      std::size_t b = 0;
      int crossing = 0;
      if (next_row(n, rules, here, way, b, crossing)) {
        join_rows(c, a, b, crossing, n[0], rules, sets);
      }
    }
  }
}

}  // namespace

Components find_components(const VoxelView& voxels, Phase phase,
                           const std::array<bool, 3>& periodic, int axis) {
  Components out = find_runs(voxels, phase);
  const Int3 n = voxels.n;
  const Rules rules{phase == Phase::grain, periodic, axis};
  Sets sets(out.run.size());
  join_all(out, n, rules, sets);

  std::vector<std::int32_t> number(out.run.size(), -1);
  std::size_t row = 0;
  for (std::size_t i = 0; i < out.run.size(); ++i) {
    while (out.row[row + 1] <= i) {
      ++row;
    }
    const std::int32_t root = sets.find(static_cast<std::int32_t>(i));
    std::int32_t& id = number[static_cast<std::size_t>(root)];
    if (id < 0) {
      id = static_cast<std::int32_t>(out.component.size());
      out.component.push_back({0, false, false, sets.wraps(root)});
    }
    Run& run = out.run[i];
    run.component = id;
    Component& part = out.component[static_cast<std::size_t>(id)];
    part.voxels += run.past - run.first;
    const int j = static_cast<int>(row % static_cast<std::size_t>(n[1]));
    const int k = static_cast<int>(row / static_cast<std::size_t>(n[1]));
    const int low = axis == 0 ? run.first : axis == 1 ? j : k;
    const int high = axis == 0 ? run.past - 1 : low;
    part.touches_low |= low == 0;
    part.touches_high |= high == n[static_cast<std::size_t>(axis)] - 1;
  }
  return out;
}

}  // namespace porefines::geom
