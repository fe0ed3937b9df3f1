// SPDX-License-Identifier: MPL-2.0
// What a rank spends in messages, counted at the door of MPI.
#pragma once

#include "core/types.hpp"
#include "par/communicator.hpp"

namespace porefines::par {

/// Of this rank since MPI_Init. Every MPI call of ours goes through traffic.cpp, which times it and passes it on (the
/// profiling interface of the MPI standard): about 50 ns a call, no change anywhere else.
struct Traffic {
  Real halo_seconds = 0;        ///< in messages between neighbours
  Real collective_seconds = 0;  ///< in reductions, broadcasts, gathers
  Index messages = 0;           ///< sent to neighbours
  Real bytes = 0;               ///< in them
  Index collectives = 0;
};

[[nodiscard]] Traffic traffic();

/// Of all ranks, for the summary.
///
/// A rank that comes early waits inside of a message for the last one, which itself waits for nobody: what a rank
/// spends above the one that spends least is waiting, the rest is the messages' own cost.
///
///     halo = min over ranks, reductions = min over ranks, waiting = mean of the sum - both
struct TrafficShares {
  Real halo = 0;        ///< [s] per rank
  Real reductions = 0;  ///< [s]
  Real waiting = 0;     ///< [s]
  Real messages = 0;    ///< mean per rank
  Real bytes = 0;       ///< mean per rank
  Real collectives = 0;
};
/// Collective. Test: mpi/traffic.
[[nodiscard]] TrafficShares share_traffic(const Traffic& mine, const Communicator& comm);

}  // namespace porefines::par
