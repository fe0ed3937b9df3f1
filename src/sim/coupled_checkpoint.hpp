// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include "io/provenance.hpp"
#include "sim/coupled_state.hpp"

namespace porefines::sim {

/// Everything that the run needs to go on, in <folder>/checkpoint.h5: fields, particles with their
/// contacts, injection, counters. Collective.
/// @throws RunError  on every rank; the checkpoint before stays
void write_checkpoint(const CoupledRun& run, const std::string& folder,
                      const io::Provenance& provenance);

/// Puts a run that was just made where the folder's checkpoint is. On as many ranks it goes on bit
/// for bit; on another number the flow is solved anew, and runs agree to the solver's tolerance.
/// Collective.
/// @throws InputError  there is none, or it is of another case
void go_on(CoupledRun& run, const std::string& folder);

}  // namespace porefines::sim
