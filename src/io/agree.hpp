// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include <mpi.h>

namespace porefines::io {

/// Makes a failure on one rank a failure on all, so that none waits for the others for ever.
///
/// @param failure  what went wrong on this rank; empty when nothing did
/// @throws RunError  on every rank, with the message of the lowest rank that failed
/// Collective; one reduction when nothing failed.
void throw_everywhere(MPI_Comm comm, const std::string& failure);

}  // namespace porefines::io
