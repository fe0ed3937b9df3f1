// SPDX-License-Identifier: MPL-2.0
// Bytes from rank to rank.
#pragma once

#include <cstddef>
#include <cstring>
#include <type_traits>
#include <vector>

#include <mpi.h>

#include "core/types.hpp"

namespace porefines::dem {

template <typename T>
void put(std::vector<std::byte>& out, const T* data, std::size_t count = 1) {
  static_assert(std::is_trivially_copyable_v<T>);
  const auto* bytes = reinterpret_cast<const std::byte*>(data);
  out.insert(out.end(), bytes, bytes + sizeof(T) * count);
}

template <typename T>
const std::byte* take(const std::byte* from, T* data, std::size_t count = 1) {
  std::memcpy(static_cast<void*>(data), from, sizeof(T) * count);
  return from + sizeof(T) * count;
}

/// Sends bytes of unknown length one way round; either end may be absent (-1).
inline std::vector<std::byte> pass_on(MPI_Comm comm, const std::vector<std::byte>& out, int to,
                                      int from) {
  const int dest = to < 0 ? MPI_PROC_NULL : to;
  const int source = from < 0 ? MPI_PROC_NULL : from;
  Index sizes[2] = {static_cast<Index>(out.size()), 0};
  MPI_Sendrecv(&sizes[0], 1, MPI_INT64_T, dest, 0, &sizes[1], 1, MPI_INT64_T, source, 0, comm,
               MPI_STATUS_IGNORE);
  std::vector<std::byte> in(static_cast<std::size_t>(sizes[1]));
  MPI_Sendrecv(out.data(), static_cast<int>(out.size()), MPI_BYTE, dest, 1, in.data(),
               static_cast<int>(in.size()), MPI_BYTE, source, 1, comm, MPI_STATUS_IGNORE);
  return in;
}

}  // namespace porefines::dem
