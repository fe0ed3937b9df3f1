// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <numeric>
#include <type_traits>
#include <vector>

#include "par/communicator.hpp"

namespace porefines::par {

/// All ranks' records on rank 0, in the order of ranks; empty elsewhere. Collective.
/// At most 2^31 records in all, of any size.
template <typename Record>
[[nodiscard]] std::vector<Record> gather(const Communicator& comm,
                                         const std::vector<Record>& mine) {
  static_assert(std::is_trivially_copyable_v<Record>);
  MPI_Datatype type = MPI_DATATYPE_NULL;
  MPI_Type_contiguous(static_cast<int>(sizeof(Record)), MPI_BYTE, &type);
  MPI_Type_commit(&type);
  const int count = static_cast<int>(mine.size());
  std::vector<int> counts(static_cast<std::size_t>(comm.size()));
  MPI_Gather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, comm.handle());
  std::vector<int> starts(counts.size(), 0);
  std::partial_sum(counts.begin(), counts.end() - 1, starts.begin() + 1);
  std::vector<Record> all(comm.is_root() ? static_cast<std::size_t>(starts.back()) +
                                               static_cast<std::size_t>(counts.back())
                                         : 0);
  MPI_Gatherv(mine.data(), count, type, all.data(), counts.data(), starts.data(), type, 0,
              comm.handle());
  MPI_Type_free(&type);
  return all;
}

/// Gives everybody the vector of rank 0. Collective.
template <typename T>
void broadcast(const Communicator& comm, std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  auto count = static_cast<Index>(values.size());
  MPI_Bcast(&count, sizeof count, MPI_BYTE, 0, comm.handle());
  values.resize(static_cast<std::size_t>(count));
  MPI_Bcast(values.data(), static_cast<int>(values.size() * sizeof(T)), MPI_BYTE, 0, comm.handle());
}

}  // namespace porefines::par
