// SPDX-License-Identifier: MPL-2.0
#include "io/agree.hpp"

#include "core/error.hpp"

namespace porefines::io {

void throw_everywhere(MPI_Comm comm, const std::string& failure) {
  int rank = 0;
  int size = 1;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &size);
  const int mine = failure.empty() ? size : rank;
  int first = size;
  MPI_Allreduce(&mine, &first, 1, MPI_INT, MPI_MIN, comm);
  if (first == size) {
    return;
  }
  std::string message = failure;
  int length = static_cast<int>(message.size());
  MPI_Bcast(&length, 1, MPI_INT, first, comm);
  message.resize(static_cast<std::size_t>(length));
  MPI_Bcast(message.data(), length, MPI_CHAR, first, comm);
  throw RunError(message);
}

}  // namespace porefines::io
