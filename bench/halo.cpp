// SPDX-License-Identifier: MPL-2.0
// What cutting the box costs: time to find the cuts, messages and bytes of one sweep, work that
// ranks repeat for each other.
#include <algorithm>

#include <benchmark/benchmark.h>

#include "flow/smoother.hpp"
#include "media.hpp"

namespace porefines::bench {
namespace {

struct Exchange {
  Index messages = 0;
  Index bytes = 0;
  Real repeated = 0;  ///< cells smoothed beyond the block / cells of the block
};

/// What one rank sends for one exchange of u, v, w and p before a sweep, as grid::Halo does it:
/// axis after axis, `depth` layers to the high and depth + 1 to the low side, across it the ghosts of
/// the axes before. Wrapping within a block needs no message.
Exchange exchange(const par::Decomposition& cut, int rank, const std::array<bool, 3>& periodic) {
  constexpr Index fields = 4;
  constexpr int depth = flow::sweep_depth;
  const Int3 n = cut.extent(rank);
  const Int3 here = cut.coordinates(rank);
  Exchange out;
  Index widened = 1;
  std::array<Index, 3> across{n[0] + 1, n[1] + 1, n[2] + 1};
  for (int a = 0; a < 3; ++a) {
    const Index face = across[(a + 1) % 3] * across[(a + 2) % 3] * fields * Index{sizeof(float)};
    const bool to_low = cut.ranks[a] > 1 && (here[a] > 0 || periodic[a]);
    const bool to_high = cut.ranks[a] > 1 && (here[a] + 1 < cut.ranks[a] || periodic[a]);
    out.messages += (to_low ? 1 : 0) + (to_high ? 1 : 0);
    out.bytes += face * ((to_low ? depth + 1 : 0) + (to_high ? depth : 0));
    const bool ghosts = cut.ranks[a] > 1 || periodic[a];
    across[a] += ghosts ? 2 * depth : 2;
    widened *= n[a] + (ghosts ? 4 : 0);  // two layers on average over the four stages
  }
  out.repeated = static_cast<Real>(widened) / static_cast<Real>(product(n)) - 1;
  return out;
}

void decomposition(benchmark::State& state, const Medium& (*medium)()) {
  const Medium& m = medium();
  const auto ranks = static_cast<int>(state.range(0));
  par::Decomposition d;
  for (auto _ : state) {
    d = cut(m, ranks);
  }
  Exchange most;
  Index largest = 0;
  for (int rank = 0; rank < ranks; ++rank) {
    const Exchange e = exchange(d, rank, m.boundaries.periodic());
    most = {std::max(most.messages, e.messages), std::max(most.bytes, e.bytes),
            std::max(most.repeated, e.repeated)};
    largest = std::max(largest, product(d.extent(rank)));
  }
  state.counters["sent_B"] = static_cast<double>(most.bytes);
  state.counters["messages"] = static_cast<double>(most.messages);
  state.counters["repeated_%"] = 100 * most.repeated;
  state.counters["imbalance_%"] =
      100 * (static_cast<double>(largest) * ranks / static_cast<double>(product(m.cells)) - 1);
}

BENCHMARK_CAPTURE(decomposition, spheres, sphere_array)
    ->Arg(1)
    ->Arg(2)
    ->Arg(8)
    ->Arg(64)
    ->Iterations(100)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(decomposition, micromodel, micromodel)
    ->Arg(1)
    ->Arg(2)
    ->Arg(8)
    ->Arg(64)
    ->Iterations(100)
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace porefines::bench
