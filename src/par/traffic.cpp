// SPDX-License-Identifier: MPL-2.0
// Times every MPI call that porefines makes while it solves: the names that MPI reserves for this (chapter "Tool support" of
// the standard). The linker finds these before those of the library.
#include "par/traffic.hpp"

#include <array>
#include <chrono>

#include <mpi.h>

namespace porefines::par {
namespace {

Traffic& counted() {
  static Traffic totals;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)
  return totals;
}

Real now() {
  return std::chrono::duration<Real>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

template <typename Call>
int in_halo(const Call& call) {
  const Real start = now();
  const int result = call();
  counted().halo_seconds += now() - start;
  return result;
}

template <typename Call>
int in_collective(const Call& call) {
  const Real start = now();
  const int result = call();
  counted().collective_seconds += now() - start;
  ++counted().collectives;
  return result;
}

void count_message(int count, MPI_Datatype type, int to) {
  if (to != MPI_PROC_NULL) {
    int size = 0;
    MPI_Type_size(type, &size);
    ++counted().messages;
    counted().bytes += static_cast<Real>(size) * count;
  }
}

}  // namespace

Traffic traffic() {
  return counted();
}

TrafficShares share_traffic(const Traffic& mine, const Communicator& comm) {
  const auto mean = [&](Real value) { return comm.sum(value) / comm.size(); };
  TrafficShares shares;
  shares.halo = comm.min(mine.halo_seconds);
  shares.reductions = comm.min(mine.collective_seconds);
  shares.waiting =
      mean(mine.halo_seconds + mine.collective_seconds) - shares.halo - shares.reductions;
  shares.messages = mean(static_cast<Real>(mine.messages));
  shares.bytes = mean(mine.bytes);
  shares.collectives = mean(static_cast<Real>(mine.collectives));
  return shares;
}

}  // namespace porefines::par

using porefines::par::count_message;
using porefines::par::in_collective;
using porefines::par::in_halo;

extern "C" {

int MPI_Isend(const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm,
              MPI_Request* request) {
  count_message(count, type, to);
  return in_halo([&] { return PMPI_Isend(data, count, type, to, tag, comm, request); });
}

int MPI_Irecv(void* data, int count, MPI_Datatype type, int from, int tag, MPI_Comm comm,
              MPI_Request* request) {
  return in_halo([&] { return PMPI_Irecv(data, count, type, from, tag, comm, request); });
}

int MPI_Waitall(int count, MPI_Request* requests, MPI_Status* statuses) {
  return in_halo([&] { return PMPI_Waitall(count, requests, statuses); });
}

int MPI_Sendrecv(const void* data, int count, MPI_Datatype type, int to, int tag, void* got,
                 int got_count, MPI_Datatype got_type, int from, int got_tag, MPI_Comm comm,
                 MPI_Status* status) {
  count_message(count, type, to);
  return in_halo([&] {
    return PMPI_Sendrecv(data, count, type, to, tag, got, got_count, got_type, from, got_tag, comm,
                         status);
  });
}

int MPI_Allreduce(const void* data, void* result, int count, MPI_Datatype type, MPI_Op op,
                  MPI_Comm comm) {
  return in_collective([&] { return PMPI_Allreduce(data, result, count, type, op, comm); });
}

int MPI_Reduce(const void* data, void* result, int count, MPI_Datatype type, MPI_Op op, int root,
               MPI_Comm comm) {
  return in_collective([&] { return PMPI_Reduce(data, result, count, type, op, root, comm); });
}

int MPI_Bcast(void* data, int count, MPI_Datatype type, int root, MPI_Comm comm) {
  return in_collective([&] { return PMPI_Bcast(data, count, type, root, comm); });
}

int MPI_Barrier(MPI_Comm comm) {
  return in_collective([&] { return PMPI_Barrier(comm); });
}

int MPI_Allgather(const void* data, int count, MPI_Datatype type, void* result, int result_count,
                  MPI_Datatype result_type, MPI_Comm comm) {
  return in_collective(
      [&] { return PMPI_Allgather(data, count, type, result, result_count, result_type, comm); });
}

int MPI_Allgatherv(const void* data, int count, MPI_Datatype type, void* result, const int* counts,
                   const int* starts, MPI_Datatype result_type, MPI_Comm comm) {
  return in_collective([&] {
    return PMPI_Allgatherv(data, count, type, result, counts, starts, result_type, comm);
  });
}

}  // extern "C"
