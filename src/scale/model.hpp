// SPDX-License-Identifier: MPL-2.0
// A model of the time on many processes, from counts of messages and a few measured runs.
#pragma once

#include <vector>

#include "core/types.hpp"

namespace porefines::scale {

/// One measured run.
struct Measured {
  int ranks = 1;
  Real seconds = 0;      ///< wall time
  Real halo = 0;         ///< [s] messages between neighbours
  Real reductions = 0;   ///< [s] collectives
  Real waiting = 0;      ///< [s] for the slowest rank
  Real messages = 0;     ///< per rank
  Real bytes = 0;        ///< per rank
  Real collectives = 0;  ///< per rank

  [[nodiscard]] Real compute() const { return seconds - halo - reductions - waiting; }
};

/// What the cut into blocks asks of the rank with the most neighbours.
struct Surface {
  int neighbours = 0;  ///< faces that another rank shares
  Real cells = 0;      ///< in those faces
  Real share = 1;      ///< cells of the largest block over the mean: what the others wait for
};
/// By the decomposition that a run would use, balanced by cells.
/// @throws InputError  too many ranks for these cells
[[nodiscard]] Surface surface_of(const Int3& cells, int ranks);

/// Coefficients of
///
///     t(n) = fixed + work imbalance / n + messages(n) latency + bytes(n) / bandwidth + collectives log2(n) hop
///
/// messages(n) = cycles_messages neighbours(n), bytes(n) = bytes_per_face cells(n), from surface_of; collectives do not
/// depend on n. fixed and work: least squares of the compute times in 1/n, not negative. latency and bandwidth: of the halo
/// times, not negative; hop of the reductions. Waiting: the mean share of compute that was measured, on top of
/// the cut's own imbalance.
struct ScalingModel {
  Int3 cells{1, 1, 1};
  Real fixed = 0;  ///< [s]
  Real work = 0;   ///< [s] on one rank
  Real messages_per_face = 0;
  Real bytes_per_cell = 0;  ///< of a face
  Real latency = 0;         ///< [s] per message
  Real seconds_per_byte = 0;
  Real collectives = 0;
  Real hop = 0;            ///< [s] per collective and doubling of ranks
  Real waiting_share = 0;  ///< of compute

  /// [s] wall time on n ranks.
  [[nodiscard]] Real seconds(int ranks) const;
};

/// @param runs  at least one, with different numbers of ranks
/// Test: unit/scale (coefficients of made-up runs come back).
[[nodiscard]] ScalingModel fit_model(const Int3& cells, const std::vector<Measured>& runs);

/// The number of ranks to take: the fewest within 5 % of the least time among those measured on at most so many physical
/// cores. More ranks than cores are never recommended.
[[nodiscard]] int recommend(const std::vector<Measured>& runs, int physical_cores);

/// Numbers of ranks worth a run: powers of two up to the cores, and the cores themselves.
[[nodiscard]] std::vector<int> ranks_to_try(int physical_cores);

}  // namespace porefines::scale
