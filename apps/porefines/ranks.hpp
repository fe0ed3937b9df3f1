// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include <mpi.h>

namespace porefines {

/// Ends the program the same way on every rank.
///
/// When all ranks come here, the first one that has a message prints it on stderr, and every rank
/// gets the largest exit code. When this rank failed and others do not come within a few seconds,
/// they wait for it somewhere else: it prints its message and aborts them all.
///
/// @param comm     used for nothing else, so that the wait cannot meet another message
/// @param message  why this rank failed; empty when it did not
/// @return         the exit code of the program
[[nodiscard]] int end_together(MPI_Comm comm, int exit_code, const std::string& message);

/// For commands that start processes of their own.
/// @throws InputError  on every rank, when mpirun started more than one
void require_one_rank(const std::string& command, const std::string& hint);

}  // namespace porefines
