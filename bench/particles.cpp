// SPDX-License-Identifier: MPL-2.0
// What a coupled solve costs with 0, 100, 1,000 and 10,000 spheres on the same grid: a slit of 400 x 400 x 28
// cells, spheres of 6 cells on a shaken lattice. Warm: all have moved by half a cell. One rank.
#include <chrono>
#include <random>

#include <benchmark/benchmark.h>

#include "media.hpp"

namespace porefines::bench {
namespace {

constexpr Int3 cells{400, 400, 28};
constexpr Real diameter = 6;
constexpr int columns = 58;  // of the lattice along x and y, 4 layers: 13,456 sites
constexpr int layers = 4;

std::vector<flow::Sphere> shaken_lattice(std::size_t count) {
  std::mt19937 numbers(3);
  const auto shake = [&] { return std::generate_canonical<Real, 53>(numbers) - 0.5; };
  const Real pitch = static_cast<Real>(cells[0]) / columns;
  const Real rise = static_cast<Real>(cells[2]) / layers;
  constexpr std::size_t sites = std::size_t{columns} * columns * layers;
  std::vector<flow::Sphere> all;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t site = k * sites / count;  // spread over the whole slit
    flow::Sphere q;
    q.id = k;
    q.radius = diameter / 2;
    q.position = {(static_cast<Real>(site % columns) + 0.5 + 0.1 * shake()) * pitch,
                  (static_cast<Real>(site / columns % columns) + 0.5 + 0.1 * shake()) * pitch,
                  (static_cast<Real>(site / columns / columns) + 0.5 + 0.1 * shake()) * rise};
    all.push_back(q);
  }
  return all;
}

void coupled_step(benchmark::State& state) {
  const par::Communicator comm = par::Communicator::self();
  flow::Boundaries walls;
  walls.kind[4] = walls.kind[5] = flow::FaceKind::wall;
  par::LayerWork work;
  for (std::size_t a = 0; a < 3; ++a) {
    work[a].assign(static_cast<std::size_t>(cells[a]), 1);
  }
  flow::StokesSolver solver(comm, par::decompose(cells, 1, work), {1, 1, 1}, walls, 1.0);
  solver.set_surface([](const Vec3&) { return 1e3; });
  flow::Drive drive;
  drive.force = {1, 0, 0};
  std::vector<flow::Sphere> spheres = shaken_lattice(static_cast<std::size_t>(state.range(0)));
  flow::SolveOptions options;
  options.tolerance = 1e-4;
  solver.set_spheres(spheres);
  (void)solver.solve(drive, options);
  int cycles = 0;
  for (auto _ : state) {
    for (flow::Sphere& q : spheres) {
      q.position.x = std::fmod(q.position.x + 0.5, static_cast<Real>(cells[0]));
    }
    solver.set_spheres(spheres);
    cycles += solver.solve(drive, options).cycles;
  }
  state.counters["spheres"] = static_cast<double>(spheres.size());
  state.counters["cycles"] = benchmark::Counter(cycles, benchmark::Counter::kAvgIterations);
}

BENCHMARK(coupled_step)
    ->Arg(0)
    ->Arg(100)
    ->Arg(1000)
    ->Arg(10000)
    ->Iterations(2)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace porefines::bench
