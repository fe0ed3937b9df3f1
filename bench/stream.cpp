// SPDX-License-Identifier: MPL-2.0
// What memory gives: the yardstick for everything else here.
#include <algorithm>

#include <benchmark/benchmark.h>
#include <unistd.h>

#include "core/aligned.hpp"
#include "core/memory.hpp"
#include "par/communicator.hpp"

namespace porefines::bench {
namespace {

constexpr int repetitions = 5;

/// Floats per array: three arrays of four times the last-level cache, shared among the ranks, or a
/// quarter of the memory that is free, whichever is less.
std::size_t array_length() {
  constexpr double unknown_cache = 64e6;
  const auto told = static_cast<double>(sysconf(_SC_LEVEL3_CACHE_SIZE));
  const double cache = told > 0 ? told : unknown_cache;
  const double room = static_cast<double>(available_memory()) / 12;
  const int ranks = par::Communicator().size();
  return static_cast<std::size_t>(std::min(4 * cache, room) / sizeof(float)) / ranks / 1024 * 1024;
}

/// Runs `pass` over arrays a, b, c; `moved` arrays pass through memory each time, as STREAM counts.
template <typename Pass>
void measure(benchmark::State& state, int arrays, int moved, const Pass& pass) {
  const std::size_t n = array_length();
  std::array<AlignedVector<float>, 3> x;
  for (int k = 0; k < arrays; ++k) {
    x[k].assign(n, 0.5F);
  }
  MPI_Barrier(MPI_COMM_WORLD);
  for (auto _ : state) {
    pass(x[0].data(), x[1].data(), x[2].data(), n);
    benchmark::ClobberMemory();
  }
  const double bytes = static_cast<double>(moved) * static_cast<double>(n) * sizeof(float);
  state.counters["array_MB"] = static_cast<double>(n * sizeof(float)) / 1e6;
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes) * state.iterations());
}

void triad(benchmark::State& state) {
  measure(
      state, 3, 3,
      [](float* __restrict a, const float* __restrict b, const float* __restrict c, std::size_t n) {
#pragma omp simd
        for (std::size_t i = 0; i < n; ++i) {
          a[i] = b[i] + 0.25F * c[i];
        }
      });
}

/// In place, as smoothers work: no line is fetched only to be overwritten.
void update(benchmark::State& state) {
  measure(state, 2, 3,
          [](float* __restrict a, const float* __restrict b, const float*, std::size_t n) {
#pragma omp simd
            for (std::size_t i = 0; i < n; ++i) {
              a[i] = 0.5F * a[i] + b[i];
            }
          });
}

void read(benchmark::State& state) {
  measure(state, 1, 1, [](const float* a, const float*, const float*, std::size_t n) {
    float sum0 = 0;
    float sum1 = 0;
    const float* half = a + n / 2;
#pragma omp simd reduction(+ : sum0, sum1)
    for (std::size_t i = 0; i < n / 2; ++i) {
      sum0 += a[i];
      sum1 += half[i];
    }
    benchmark::DoNotOptimize(sum0 + sum1);
  });
}

BENCHMARK(triad)
    ->Name("stream/triad")
    ->Iterations(3)
    ->Repetitions(repetitions)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(update)
    ->Name("stream/update")
    ->Iterations(3)
    ->Repetitions(repetitions)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(read)
    ->Name("stream/read")
    ->Iterations(3)
    ->Repetitions(repetitions)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace porefines::bench
