// SPDX-License-Identifier: MPL-2.0
#include "par/decomposition.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "core/error.hpp"

namespace porefines::par {

Int3 Decomposition::coordinates(int rank) const {
  return {rank % ranks[0], (rank / ranks[0]) % ranks[1], rank / (ranks[0] * ranks[1])};
}

int Decomposition::rank_at(const Int3& c) const {
  return c[0] + ranks[0] * (c[1] + ranks[1] * c[2]);
}

Int3 Decomposition::start(int rank) const {
  const Int3 c = coordinates(rank);
  return {cuts[0][c[0]], cuts[1][c[1]], cuts[2][c[2]]};
}

Int3 Decomposition::extent(int rank) const {
  const Int3 c = coordinates(rank);
  Int3 n{};
  for (int a = 0; a < 3; ++a) {
    n[a] = cuts[a][c[a] + 1] - cuts[a][c[a]];
  }
  return n;
}

Decomposition Decomposition::coarsened(const std::array<bool, 3>& halved) const {
  Decomposition coarse = *this;
  coarse.alignment = alignment / 2;
  for (int a = 0; a < 3; ++a) {
    if (!halved[a]) {
      continue;
    }
    coarse.cells[a] = (cells[a] + 1) / 2;
    for (int& cut : coarse.cuts[a]) {
      cut = (cut + 1) / 2;
    }
  }
  return coarse;
}

namespace {

/// Cuts at multiples of `alignment` nearest to equal shares of the work.
std::vector<int> cut_axis(int cells, int parts, const std::vector<Real>& work, int alignment) {
  std::vector<int> cuts(parts + 1, 0);
  cuts[parts] = cells;
  const Real total = std::accumulate(work.begin(), work.end(), Real{0});
  Real done = 0;
  int layer = 0;
  for (int p = 1; p < parts; ++p) {
    while (layer < cells && done + work[layer] / 2 < total * p / parts) {
      done += work[layer++];
    }
    const int least = cuts[p - 1] + smallest_block;
    const int most = cells - smallest_block * (parts - p);
    const int up = (least + alignment - 1) / alignment * alignment;
    const int down = most / alignment * alignment;
    const int nearest = (layer + alignment / 2) / alignment * alignment;
    cuts[p] = std::clamp(nearest, up, std::max(up, down));
  }
  return cuts;
}

bool fits(const Int3& cells, const Int3& ranks) {
  for (int a = 0; a < 3; ++a) {
    if (ranks[a] > 1 && cells[a] < ranks[a] * smallest_block) {
      return false;
    }
  }
  return true;
}

/// Halo cells that all blocks together receive; cuts across x cost more, since its memory is strided.
Real halo_cost(const Int3& cells, const Int3& ranks) {
  const std::array<Real, 3> price{2.0, 1.2, 1.0};
  Real cost = 0;
  for (int a = 0; a < 3; ++a) {
    cost += price[a] * (ranks[a] - 1) * static_cast<Real>(product(cells)) / cells[a];
  }
  return cost;
}

Int3 choose_ranks(const Int3& cells, int size) {
  Int3 best{0, 0, 0};
  for (int px = 1; px <= size; ++px) {
    for (int py = 1; size % px == 0 && py <= size / px; ++py) {
      const Int3 candidate{px, py, size / px / py};
      if ((size / px) % py != 0 || !fits(cells, candidate)) {
        continue;
      }
      if (best[0] == 0 || halo_cost(cells, candidate) < halo_cost(cells, best)) {
        best = candidate;
      }
    }
  }
  return best;
}

/// Largest power of two that leaves every cut block room for its ghosts and good balance.
int choose_alignment(const Int3& cells, const Int3& ranks) {
  int alignment = 64;
  for (int a = 0; a < 3; ++a) {
    while (ranks[a] > 1 && alignment > 1 &&
           cells[a] / ranks[a] < std::max(smallest_block, 6 * alignment)) {
      alignment /= 2;
    }
  }
  return alignment;
}

}  // namespace

Decomposition decompose(const Int3& cells, int size, const LayerWork& work,
                        const std::optional<Int3>& forced) {
  Decomposition d;
  d.cells = cells;
  d.ranks = forced ? *forced : choose_ranks(cells, size);
  if (forced && product(*forced) != size) {
    throw InputError(
        fmt::format("[grid] decomposition: {} x {} x {} blocks for {} ranks; try \"auto\"",
                    d.ranks[0], d.ranks[1], d.ranks[2], size));
  }
  if (d.ranks[0] == 0 || !fits(cells, d.ranks)) {
    Index most = 1;
    for (int a = 0; a < 3; ++a) {
      most *= std::max(1, cells[a] / smallest_block);
    }
    throw InputError(
        fmt::format("{} x {} x {} cells cannot be cut into {} blocks of at least {} cells "
                    "a side; try fewer ranks (at most {})",
                    cells[0], cells[1], cells[2], size, smallest_block, most));
  }
  d.alignment = size == 1 ? 1 << 20 : choose_alignment(cells, d.ranks);
  for (int a = 0; a < 3; ++a) {
    d.cuts[a] = cut_axis(cells[a], d.ranks[a], work[a], std::min(d.alignment, 64));
  }
  return d;
}

}  // namespace porefines::par
