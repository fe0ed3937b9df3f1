// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <exception>
#include <string>

#include <mpi.h>

namespace porefines::io {

/// Makes a failure on one rank a failure on all, so that none waits for the others for ever.
///
/// @param failure  what went wrong on this rank; empty when nothing did
/// @throws RunError  on every rank, with the message of the lowest rank that failed
/// Collective; one reduction when nothing failed.
void throw_everywhere(MPI_Comm comm, const std::string& failure);

/// Runs `act` and turns a failure on any rank into one on all. Collective.
template <typename Act>
void together(MPI_Comm comm, const Act& act) {
  std::string failure;
  try {
    act();
  } catch (const std::exception& error) {
    failure = error.what();
  }
  throw_everywhere(comm, failure);
}

}  // namespace porefines::io
