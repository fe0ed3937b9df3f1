// SPDX-License-Identifier: MPL-2.0
// Test programs start MPI themselves, so that each also runs under mpirun.
#include <gtest/gtest.h>
#include <mpi.h>

#include "par/mpi_defaults.hpp"

int main(int argc, char** argv) {
  porefines::par::set_mpi_defaults();
  MPI_Init(&argc, &argv);
  ::testing::InitGoogleTest(&argc, argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank != 0) {
    auto& listeners = ::testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
  }
  int failed = RUN_ALL_TESTS();
  int anywhere = 0;
  MPI_Allreduce(&failed, &anywhere, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  MPI_Finalize();
  return anywhere;
}
