// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <span>

#include <mpi.h>

#include "core/types.hpp"

namespace porefines::par {

/// A group of ranks and its reductions. Copies share the same MPI communicator.
class Communicator {
 public:
  explicit Communicator(MPI_Comm comm = MPI_COMM_WORLD);

  [[nodiscard]] static Communicator self() { return Communicator(MPI_COMM_SELF); }
  [[nodiscard]] MPI_Comm handle() const { return comm_; }
  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] bool is_root() const { return rank_ == 0; }

  /// Sums over all ranks; collective. The same order on the same number of ranks.
  [[nodiscard]] Real sum(Real value) const;
  [[nodiscard]] Index sum(Index value) const;
  void sum(std::span<Real> values) const;
  [[nodiscard]] Real max(Real value) const;
  [[nodiscard]] Real min(Real value) const;

 private:
  MPI_Comm comm_;
  int rank_ = 0;
  int size_ = 1;
};

}  // namespace porefines::par
