// SPDX-License-Identifier: MPL-2.0
// Whole solves: set-up and iteration to 1e-6, from nothing.
#include <chrono>

#include <benchmark/benchmark.h>

#include "media.hpp"

namespace porefines::bench {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void solve(benchmark::State& state, const Medium& (*medium)()) {
  const Medium& m = medium();
  const par::Communicator comm;
  for (auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    flow::StokesSolver solver(comm, cut(m, comm.size()), m.spacing, m.boundaries, viscosity);
    solver.set_surface(m.distance);
    const double setup = seconds_since(start);
    const flow::SolveReport report = solver.solve(m.drive, {});
    const double total = seconds_since(start);
    const auto cells = static_cast<double>(solver.fluid_cells());
    const auto bytes = static_cast<double>(solver.hierarchy().bytes());  // of this rank
    state.counters["hierarchy_B/cell"] = comm.sum(bytes) / cells;
    state.counters["mobility_sweeps"] = solver.hierarchy().mobility_sweeps();
    state.counters["cycles"] = report.cycles;
    state.counters["setup_s"] = setup;
    state.counters["solve_s"] = total - setup;
    state.counters["cells/s"] = cells / total;
    state.counters["setup_cells/s"] = cells / setup;
    state.counters["solve_cells/s"] = cells / (total - setup);
  }
}

BENCHMARK_CAPTURE(solve, spheres, sphere_array)
    ->Iterations(1)
    ->Repetitions(2)
    ->UseRealTime()
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(solve, micromodel, micromodel)
    ->Iterations(1)
    ->Repetitions(2)
    ->UseRealTime()
    ->Unit(benchmark::kSecond);

}  // namespace
}  // namespace porefines::bench
