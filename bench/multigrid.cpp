// SPDX-License-Identifier: MPL-2.0
// One smoothing sweep and one multigrid cycle.
#include <benchmark/benchmark.h>

#include "flow/smoother.hpp"
#include "media.hpp"
#include "traffic.hpp"

namespace porefines::bench {
namespace {

using MediumOf = const Medium& (*)();

struct Messages {
  Index count = 0;
  Index bytes = 0;
};

Messages messages(flow::Hierarchy& hierarchy) {
  Messages total;
  for (int l = 0; l < hierarchy.size(); ++l) {
    total.count += hierarchy.level(l).halo.messages();
    total.bytes += hierarchy.level(l).halo.bytes();
  }
  return total;
}

/// Times `work` and counts its cells, bytes and messages. A fixed number of iterations: all ranks
/// must do the same.
template <typename Work>
void measure(benchmark::State& state, flow::StokesSolver& solver, double bytes, const Work& work) {
  const Messages before = messages(solver.hierarchy());
  MPI_Barrier(MPI_COMM_WORLD);
  for (auto _ : state) {
    work();
  }
  const Messages after = messages(solver.hierarchy());
  const auto per_iteration = [&](Index from, Index to) {
    return static_cast<double>(to - from) / static_cast<double>(state.iterations());
  };
  const auto iterations = static_cast<double>(state.iterations());
  state.counters["cells/s"] = benchmark::Counter(
      static_cast<double>(solver.fluid_cells()) * iterations, benchmark::Counter::kIsRate);
  state.counters["messages"] = per_iteration(before.count, after.count);
  state.counters["sent_B"] = per_iteration(before.bytes, after.bytes);
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes * iterations));
}

void sweep(benchmark::State& state, MediumOf medium) {
  flow::StokesSolver& solver = prepared(medium());
  flow::Level& level = solver.hierarchy().finest();
  measure(state, solver, sweep_bytes(level), [&] { flow::sweep(level, false, false); });
}

void cycle(benchmark::State& state, MediumOf medium) {
  flow::StokesSolver& solver = prepared(medium());
  flow::Hierarchy& hierarchy = solver.hierarchy();
  measure(state, solver, cycle_bytes(hierarchy), [&] { flow::cycle(hierarchy, [] {}); });
}

void configure(benchmark::internal::Benchmark* b, int iterations) {
  b->Iterations(iterations)->Repetitions(5)->UseRealTime()->Unit(benchmark::kMillisecond);
}

const bool registered = [] {
  const std::array<std::pair<std::string, MediumOf>, 2> media{
      {{"spheres", sphere_array}, {"micromodel", micromodel}}};
  for (const auto& [name, medium] : media) {
    configure(benchmark::RegisterBenchmark(("sweep/" + name).c_str(), sweep, medium), 10);
    configure(benchmark::RegisterBenchmark(("cycle/" + name).c_str(), cycle, medium), 3);
  }
  configure(benchmark::RegisterBenchmark("sweep/in_cache", sweep, small_box), 500);
  return true;
}();

}  // namespace
}  // namespace porefines::bench
