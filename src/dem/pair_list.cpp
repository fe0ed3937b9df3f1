// SPDX-License-Identifier: MPL-2.0
#include "dem/pair_list.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace porefines::dem {

namespace {

struct Bounds {
  Vec3 low{1e300, 1e300, 1e300};
  Vec3 high{-1e300, -1e300, -1e300};
};

Bounds bounds_of(const Particles& p, std::size_t count) {
  Bounds b;
  for (std::size_t i = 0; i < count; ++i) {
    for (int a = 0; a < 3; ++a) {
      b.low[a] = std::min(b.low[a], p.position[i][a]);
      b.high[a] = std::max(b.high[a], p.position[i][a]);
    }
  }
  return b;
}

/// The particles of one size class, sorted into cells of at least the reach of that class.
struct SizeGrid {
  Vec3 low;
  Real inverse = 0;  ///< 1 / side of a cell
  Int3 n{1, 1, 1};
  std::vector<std::uint32_t> start;  ///< first entry of each cell
  std::vector<std::uint32_t> index;  ///< particles, cell by cell
  AlignedVector<Vec3> position;      ///< theirs, in the same order
  AlignedVector<Real> radius;

  /// Cell along an axis, one beyond the grid at most: outside there is nothing to find.
  [[nodiscard]] int cell(Real x, int axis) const {
    const Real c = std::floor((x - low[axis]) * inverse);
    return static_cast<int>(std::clamp(c, -2.0, n[axis] + 1.0));
  }
};

SizeGrid make_grid(const Particles& p, const std::vector<std::uint32_t>& members,
                   const Bounds& bounds, Real side) {
  SizeGrid g;
  g.low = bounds.low;
  const auto cells_for = [&](Real s, int a) {
    return std::floor((bounds.high[a] - bounds.low[a]) / s) + 1;
  };
  const Real most = 8.0 * static_cast<Real>(members.size()) + 64;
  while (cells_for(side, 0) * cells_for(side, 1) * cells_for(side, 2) > most) {
    side *= 1.26;  // few particles in a large box: larger cells are as good
  }
  g.inverse = 1 / side;
  for (int a = 0; a < 3; ++a) {
    g.n[a] = static_cast<int>(cells_for(side, a));
  }
  std::vector<std::uint32_t> cell(members.size());
  g.start.assign(product(g.n) + 1, 0);
  for (std::size_t m = 0; m < members.size(); ++m) {
    const Vec3& x = p.position[members[m]];
    const int i = std::clamp(g.cell(x.x, 0), 0, g.n[0] - 1);
    const int j = std::clamp(g.cell(x.y, 1), 0, g.n[1] - 1);
    const int k = std::clamp(g.cell(x.z, 2), 0, g.n[2] - 1);
    cell[m] = static_cast<std::uint32_t>(i + Index{g.n[0]} * (j + Index{g.n[1]} * k));
    ++g.start[cell[m] + 1];
  }
  for (std::size_t c = 1; c < g.start.size(); ++c) {
    g.start[c] += g.start[c - 1];
  }
  g.index.resize(members.size()), g.position.resize(members.size()),
      g.radius.resize(members.size());
  std::vector<std::uint32_t> next(g.start.begin(), g.start.end() - 1);
  for (std::size_t m = 0; m < members.size(); ++m) {
    const std::uint32_t at = next[cell[m]]++;
    g.index[at] = members[m];
    g.position[at] = p.position[members[m]];
    g.radius[at] = p.radius[members[m]];
  }
  return g;
}

/// Calls near(b) for the members of a grid that come within `skin` of particle a.
template <typename Near>
Index search(const SizeGrid& g, const Vec3& x, Real reach, const Near& near) {
  Index tried = 0;
  Int3 c{g.cell(x.x, 0), g.cell(x.y, 1), g.cell(x.z, 2)};
  const int i0 = std::max(c[0] - 1, 0);
  const int i1 = std::min(c[0] + 1, g.n[0] - 1);
  for (int k = std::max(c[2] - 1, 0); k <= std::min(c[2] + 1, g.n[2] - 1); ++k) {
    for (int j = std::max(c[1] - 1, 0); j <= std::min(c[1] + 1, g.n[1] - 1); ++j) {
      if (i0 > i1) {
        continue;
      }
      const Index row = Index{g.n[0]} * (j + Index{g.n[1]} * k);
      const std::uint32_t end = g.start[row + i1 + 1];
      for (std::uint32_t b = g.start[row + i0]; b < end; ++b) {
        const Vec3 d = g.position[b] - x;
        const Real range = reach + g.radius[b];
        ++tried;
        if (dot(d, d) < range * range) {
          near(g.index[b]);
        }
      }
    }
  }
  return tried;
}

/// Sorts pairs by first, then second.
void sort_pairs(std::size_t owned, const PairList& found, PairList& out) {
  std::vector<std::uint32_t> start(owned + 1, 0);
  for (const std::uint32_t i : found.first) {
    ++start[i + 1];
  }
  for (std::size_t i = 1; i <= owned; ++i) {
    start[i] += start[i - 1];
  }
  out.first.resize(found.size()), out.second.resize(found.size());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (std::size_t k = 0; k < found.size(); ++k) {
    const std::uint32_t at = next[found.first[k]]++;
    out.first[at] = found.first[k];
    out.second[at] = found.second[k];
  }
  for (std::size_t i = 0; i < owned; ++i) {
    std::sort(out.second.begin() + start[i], out.second.begin() + start[i + 1]);
  }
}

/// Size class of a radius: 0 for the smallest, one more for every doubling.
int size_class(Real radius, Real smallest) {
  return std::max(0, static_cast<int>(std::floor(std::log2(radius / smallest))));
}

}  // namespace

Index find_pairs(const Particles& p, Real skin, PairList& out) {
  out.first.clear(), out.second.clear();
  if (p.size() == 0) {
    return 0;
  }
  const Bounds bounds = bounds_of(p, p.size());
  const Real smallest = *std::min_element(p.radius.begin(), p.radius.end());
  std::vector<std::vector<std::uint32_t>> members;
  std::vector<int> level(p.size());
  std::vector<Real> largest;
  for (std::uint32_t i = 0; i < p.size(); ++i) {
    level[i] = size_class(p.radius[i], smallest);
    if (static_cast<std::size_t>(level[i]) >= members.size()) {
      members.resize(level[i] + 1), largest.resize(level[i] + 1, 0);
    }
    members[level[i]].push_back(i);
    largest[level[i]] = std::max(largest[level[i]], p.radius[i]);
  }
  std::vector<SizeGrid> grids;
  for (std::size_t l = 0; l < members.size(); ++l) {
    grids.push_back(make_grid(p, members[l], bounds, 2 * largest[l] + skin));
  }
  static thread_local PairList found;
  found.first.clear(), found.second.clear();
  Index tried = 0;
  for (std::uint32_t i = 0; i < p.size(); ++i) {
    for (std::size_t l = level[i]; l < grids.size(); ++l) {
      const bool same = l == static_cast<std::size_t>(level[i]);
      tried += search(grids[l], p.position[i], p.radius[i] + skin, [&](std::uint32_t j) {
        if ((same && j <= i) || std::min(i, j) >= p.owned) {
          return;
        }
        found.first.push_back(std::min(i, j));
        found.second.push_back(std::max(i, j));
      });
    }
  }
  sort_pairs(p.owned, found, out);
  return tried;
}

std::vector<std::uint32_t> spatial_order(const Particles& p, Real cell) {
  const Bounds bounds = bounds_of(p, p.owned);
  const auto spread = [](std::uint64_t v) {  // two zero bits after each of the low 21
    v &= 0x1fffff;
    v = (v | v << 32) & 0x1f00000000ffff;
    v = (v | v << 16) & 0x1f0000ff0000ff;
    v = (v | v << 8) & 0x100f00f00f00f00f;
    v = (v | v << 4) & 0x10c30c30c30c30c3;
    return (v | v << 2) & 0x1249249249249249;
  };
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(p.owned);
  for (std::uint32_t i = 0; i < p.owned; ++i) {
    std::uint64_t key = 0;
    for (int a = 0; a < 3; ++a) {
      const Real c = (p.position[i][a] - bounds.low[a]) / cell;
      key |= spread(static_cast<std::uint64_t>(std::min(c, 2097151.0))) << a;
    }
    keys[i] = {key, i};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order(p.owned);
  std::transform(keys.begin(), keys.end(), order.begin(), [](const auto& k) { return k.second; });
  return order;
}

}  // namespace porefines::dem
