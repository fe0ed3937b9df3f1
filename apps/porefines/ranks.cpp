// SPDX-License-Identifier: MPL-2.0
#include "ranks.hpp"

#include <array>
#include <chrono>
#include <cstdio>
#include <limits>
#include <thread>

#include <fmt/format.h>

#include "core/error.hpp"

namespace porefines {
namespace {

using namespace std::chrono_literals;
constexpr auto patience = 30s;
constexpr auto nap = 2ms;

void print(const std::string& message) {
  std::fflush(stdout);
  fmt::print(stderr, "porefines: {}\n", message);
}

}  // namespace

void require_one_rank(const std::string& command, const std::string& hint) {
  int ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  if (ranks > 1) {
    throw InputError(
        fmt::format("porefines {} starts its own processes, but mpirun started {} of it\nrun it "
                    "without mpirun; {}",
                    command, ranks, hint));
  }
}

int end_together(MPI_Comm comm, int exit_code, const std::string& message) {
  const bool failed = !message.empty();
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  // The larger of -rank over the failed ranks names the first of them.
  const std::array<int, 2> mine{exit_code, failed ? -rank : std::numeric_limits<int>::min()};
  std::array<int, 2> worst{};
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Iallreduce(mine.data(), worst.data(), 2, MPI_INT, MPI_MAX, comm, &request);
  const auto deadline = std::chrono::steady_clock::now() + patience;
  for (int done = 0; MPI_Test(&request, &done, MPI_STATUS_IGNORE), done == 0;) {
    if (failed && std::chrono::steady_clock::now() > deadline) {
      print(fmt::format("rank {}: {}", rank, message));
      MPI_Abort(MPI_COMM_WORLD, exit_code);
    }
    std::this_thread::sleep_for(nap);
  }
  if (failed && worst[1] == -rank) {
    print(message);
  }
  return worst[0];
}

}  // namespace porefines
