// SPDX-License-Identifier: MPL-2.0
#pragma once

namespace porefines::par {

/// What Open MPI should know before MPI_Init, unless the user has said otherwise in the environment.
/// Other MPIs do not read it.
void set_mpi_defaults();

}  // namespace porefines::par
