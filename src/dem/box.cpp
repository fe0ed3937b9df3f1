// SPDX-License-Identifier: MPL-2.0
#include "dem/box.hpp"

#include <algorithm>
#include <cmath>

namespace porefines::dem {

Vec3 Box::wrapped(Vec3 x) const {
  for (int a = 0; a < 3; ++a) {
    if (periodic[a]) {
      x[a] -= length(a) * std::floor((x[a] - low[a]) / length(a));
      x[a] = x[a] >= high[a] ? low[a] : x[a];  // rounding may land on the upper border
    }
  }
  return x;
}

int Blocks::owner(const Vec3& place) const {
  Int3 block{};
  for (int a = 0; a < 3; ++a) {
    const auto first = cuts[a].begin() + 1;
    const auto last = cuts[a].end() - 1;
    block[a] = static_cast<int>(std::upper_bound(first, last, place[a]) - first);
  }
  return rank_at(block);
}

Int3 Blocks::coordinates(int rank) const {
  return {rank % ranks[0], (rank / ranks[0]) % ranks[1], rank / (ranks[0] * ranks[1])};
}

int Blocks::rank_at(const Int3& c) const {
  return c[0] + ranks[0] * (c[1] + ranks[1] * c[2]);
}

Blocks make_blocks(const par::Decomposition& decomposition, const Box& box) {
  Blocks blocks;
  blocks.ranks = decomposition.ranks;
  for (int a = 0; a < 3; ++a) {
    for (const int cut : decomposition.cuts[a]) {
      blocks.cuts[a].push_back(box.low[a] + box.length(a) * cut / decomposition.cells[a]);
    }
  }
  return blocks;
}

Blocks even_blocks(const Box& box, int ranks, const Vec3& gravity) {
  constexpr Real across_gravity = 2;
  Blocks blocks;
  const auto falls_along = [&](int a) { return std::abs(gravity[a]) > 0.5 * norm(gravity); };
  Real smallest = -1;
  for (int px = 1; px <= ranks; ++px) {
    for (int py = 1; py <= ranks / px; ++py) {
      const Int3 parts{px, py, ranks / px / py};
      const Vec3 side{box.length(0) / parts[0], box.length(1) / parts[1], box.length(2) / parts[2]};
      Real surface = side.x * side.y + side.y * side.z + side.z * side.x;
      for (int a = 0; a < 3; ++a) {
        surface *= parts[a] > 1 && falls_along(a) ? across_gravity : 1;
      }
      if (product(parts) == ranks && (smallest < 0 || surface < smallest * (1 - 1e-12))) {
        smallest = surface;
        blocks.ranks = parts;
      }
    }
  }
  for (int a = 0; a < 3; ++a) {
    for (int cut = 0; cut <= blocks.ranks[a]; ++cut) {
      blocks.cuts[a].push_back(box.low[a] + box.length(a) * cut / blocks.ranks[a]);
    }
  }
  return blocks;
}

}  // namespace porefines::dem
