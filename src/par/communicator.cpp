// SPDX-License-Identifier: MPL-2.0
#include "par/communicator.hpp"

namespace porefines::par {

Communicator::Communicator(MPI_Comm comm) : comm_(comm) {
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &size_);
}

Real Communicator::sum(Real value) const {
  Real total = value;
  MPI_Allreduce(MPI_IN_PLACE, &total, 1, MPI_DOUBLE, MPI_SUM, comm_);
  return total;
}

Index Communicator::sum(Index value) const {
  Index total = value;
  MPI_Allreduce(MPI_IN_PLACE, &total, 1, MPI_INT64_T, MPI_SUM, comm_);
  return total;
}

void Communicator::sum(std::span<Real> values) const {
  MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_SUM,
                comm_);
}

Real Communicator::max(Real value) const {
  Real largest = value;
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, comm_);
  return largest;
}

Real Communicator::min(Real value) const {
  Real smallest = value;
  MPI_Allreduce(MPI_IN_PLACE, &smallest, 1, MPI_DOUBLE, MPI_MIN, comm_);
  return smallest;
}

}  // namespace porefines::par
