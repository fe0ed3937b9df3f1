// SPDX-License-Identifier: MPL-2.0
// Speed of the flow solver against the memory bandwidth of this machine.
//   porefines_bench [--benchmark_filter=cycle]        mpirun -n 2 porefines_bench
#include <benchmark/benchmark.h>
#include <mpi.h>

#include "media.hpp"
#include "par/communicator.hpp"
#include "par/mpi_defaults.hpp"
#include "table.hpp"

int main(int argc, char** argv) {
  porefines::par::set_mpi_defaults();
  MPI_Init(&argc, &argv);
  benchmark::Initialize(&argc, argv);
  int status = benchmark::ReportUnrecognizedArguments(argc, argv) ? 2 : 0;
  if (status == 0 && porefines::par::Communicator().is_root()) {
    porefines::bench::Fastest reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    reporter.print_ratios();
  } else if (status == 0) {
    porefines::bench::Silent reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
  }
  porefines::bench::forget_solvers();
  MPI_Finalize();
  return status;
}
