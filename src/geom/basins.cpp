// SPDX-License-Identifier: MPL-2.0
#include "geom/basins.hpp"

#include <algorithm>
#include <numeric>

#include "geom/neighbours.hpp"
#include "geom/pore_size.hpp"

namespace porefines::geom {

namespace {

std::int32_t find_root(std::vector<std::int32_t>& parent, std::int32_t a) {
  while (parent[static_cast<std::size_t>(a)] != a) {
    auto& up = parent[static_cast<std::size_t>(a)];
    up = parent[static_cast<std::size_t>(up)];
    a = up;
  }
  return a;
}

/// Voxels of the phase, the deepest first in steps of 1/64 pixel; within a step by place, which
/// is the same always and keeps memory access local (counting sort).
std::vector<std::int32_t> deepest_first(const std::vector<float>& depth) {
  const float most = std::max(0.0F, *std::max_element(depth.begin(), depth.end()));
  const auto step = [&](float d) { return static_cast<std::size_t>(64 * (most - d)); };
  std::vector<Index> first(step(0) + 2, 0);
  for (const float d : depth) {
    if (d > 0) {
      ++first[step(d) + 1];
    }
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::int32_t> order(static_cast<std::size_t>(first.back()));
  for (std::size_t v = 0; v < depth.size(); ++v) {
    if (depth[v] > 0) {
      order[static_cast<std::size_t>(first[step(depth[v])]++)] = static_cast<std::int32_t>(v);
    }
  }
  return order;
}

/// Basins while they grow and merge.
struct Growing {
  std::vector<std::int32_t> label;
  std::vector<std::int32_t> parent;
  std::vector<float> peak;

  /// Two basins meet at height h.
  void meet(std::int32_t a, std::int32_t b, float h, const Merging& merging) {
    std::int32_t high = find_root(parent, a);
    std::int32_t low = find_root(parent, b);
    if (high == low) {
      return;
    }
    if (peak[static_cast<std::size_t>(high)] < peak[static_cast<std::size_t>(low)]) {
      std::swap(high, low);
    }
    const float p = peak[static_cast<std::size_t>(low)];
    if (p - h < std::max(merging.absolute, merging.relative * p)) {
      parent[static_cast<std::size_t>(low)] = high;
    }
  }

  /// Label one voxel, the deepest that has none.
  void add(std::int32_t v, const std::vector<float>& depth, const Neighbours& around,
           const Merging& merging) {
    std::int32_t home = -1;
    std::int32_t last = -1;  // mostly one basin: look it up once
    float best = -1;
    std::array<std::int32_t, 26> met{};
    std::size_t count = 0;
    around.visit(v, [&](Index u) {
      const std::int32_t there = label[static_cast<std::size_t>(u)];
      if (there >= 0 && there != last) {
        last = met[count++] = there;
      }
      if (there >= 0 && depth[static_cast<std::size_t>(u)] > best) {
        best = depth[static_cast<std::size_t>(u)];
        home = there;
      }
    });
    const float h = depth[static_cast<std::size_t>(v)];
    if (home < 0) {
      home = static_cast<std::int32_t>(parent.size());
      parent.push_back(home);
      peak.push_back(h);
    }
    for (std::size_t m = 0; m < count; ++m) {
      meet(home, met[m], h, merging);
    }
    label[static_cast<std::size_t>(v)] = find_root(parent, home);
  }
};

/// Number the basins that are left.
Basins finish(Growing growing) {
  Basins out;
  std::vector<std::int32_t> number(growing.parent.size(), -1);
  for (std::int32_t& label : growing.label) {
    if (label < 0) {
      continue;
    }
    const auto root = static_cast<std::size_t>(find_root(growing.parent, label));
    if (number[root] < 0) {
      number[root] = static_cast<std::int32_t>(out.voxels.size());
      out.voxels.push_back(0);
      out.peak.push_back(growing.peak[root]);
    }
    label = number[root];
    ++out.voxels[static_cast<std::size_t>(label)];
  }
  out.label = std::move(growing.label);
  return out;
}

}  // namespace

Basins find_basins(const VoxelSolid& solid, Phase phase, const std::array<bool, 3>& periodic,
                   const Merging& merging) {
  std::vector<float> depth = solid.s;
  if (phase == Phase::grain) {
    std::transform(depth.begin(), depth.end(), depth.begin(), std::negate<>());
  } else {
    for (Index v = 0; v < product(solid.n); ++v) {  // no ripples along slanted channels
      float& d = depth[static_cast<std::size_t>(v)];
      d += d > 0 ? ridge_gain(solid, v) : 0;
    }
  }
  const bool diagonal = phase == Phase::pore || solid.n[2] == 1;
  const Neighbours around(solid.n, periodic, diagonal);
  Growing growing;
  growing.label.assign(depth.size(), -1);
  for (const std::int32_t v : deepest_first(depth)) {
    growing.add(v, depth, around, merging);
  }
  return finish(std::move(growing));
}

}  // namespace porefines::geom
