// SPDX-License-Identifier: MPL-2.0
// Messages are counted as they are sent.
#include "par/traffic.hpp"

#include <array>

#include <gtest/gtest.h>
#include <mpi.h>

namespace porefines::par {
namespace {

TEST(TrafficOnRanks, counts_messages_bytes_and_collectives) {
  const Communicator comm;
  const Traffic before = traffic();
  const int to = comm.rank() + 1 < comm.size() ? comm.rank() + 1 : MPI_PROC_NULL;
  const int from = comm.rank() > 0 ? comm.rank() - 1 : MPI_PROC_NULL;
  std::array<float, 25> out{};
  std::array<float, 25> in{};
  std::array<MPI_Request, 2> requests{};
  MPI_Irecv(in.data(), 25, MPI_FLOAT, from, 0, comm.handle(), &requests[0]);
  MPI_Isend(out.data(), 25, MPI_FLOAT, to, 0, comm.handle(), &requests[1]);
  MPI_Waitall(2, requests.data(), MPI_STATUSES_IGNORE);
  (void)comm.sum(1.0);
  (void)comm.max(1.0);
  const Traffic after = traffic();
  EXPECT_EQ(after.messages - before.messages, to == MPI_PROC_NULL ? 0 : 1);
  EXPECT_EQ(after.bytes - before.bytes, to == MPI_PROC_NULL ? 0 : 100);
  EXPECT_EQ(after.collectives - before.collectives, 2);
  EXPECT_GE(after.halo_seconds, before.halo_seconds);
  EXPECT_GT(after.collective_seconds, before.collective_seconds);
}

/// Made-up times: the least of all ranks is cost, what is above it is waiting.
TEST(TrafficOnRanks, waiting_is_what_the_slowest_does_not_spend) {
  const Communicator comm;
  const Traffic mine{.halo_seconds = 2.0 + comm.rank(), .collective_seconds = 1, .messages = 10};
  const TrafficShares shares = share_traffic(mine, comm);
  EXPECT_DOUBLE_EQ(shares.halo, 2);
  EXPECT_DOUBLE_EQ(shares.reductions, 1);
  EXPECT_DOUBLE_EQ(shares.waiting, 0.5 * (comm.size() - 1));
  EXPECT_DOUBLE_EQ(shares.messages, 10);
}

}  // namespace
}  // namespace porefines::par
