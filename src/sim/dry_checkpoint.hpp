// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include "io/checkpoint.hpp"
#include "io/provenance.hpp"
#include "sim/dry_state.hpp"

namespace porefines::sim {

/// Everything that the run needs to go on, in <folder>/checkpoint.h5. Collective.
/// @throws RunError  on every rank; the checkpoint before stays
void write_checkpoint(const DryRun& run, const std::string& folder,
                      const io::Provenance& provenance);

/// The parts that other kinds of run with particles have as well: the case, counters, particles.
/// The snapshot must live until the checkpoint is written.
void put_run(io::Checkpoint& checkpoint, const DryRun& run, const dem::Snapshot& snapshot);
/// @throws InputError  the checkpoint is of another case
void get_run(const io::CheckpointReader& reader, DryRun& run);

/// Puts a run that was just made where the folder's checkpoint is. Collective.
/// @throws InputError  there is none, or it is of another case: with the key that differs
void go_on(DryRun& run, const std::string& folder);

/// The first line that differs between two effective cases: "contact.friction was ..., is ...", or "".
/// When and where results are written may differ, the time at which the run ends, and [[drive]].
/// Test: unit/same_case.
[[nodiscard]] std::string difference_of_cases(const std::string& before, const std::string& now);

/// @throws InputError  the checkpoint is of another case
void require_same_case(const io::CheckpointReader& reader, const config::Case& the_case);

}  // namespace porefines::sim
