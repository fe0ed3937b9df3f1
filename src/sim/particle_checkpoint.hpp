// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "dem/system.hpp"
#include "io/checkpoint.hpp"

namespace porefines::sim {

/// Puts all of a snapshot under names "particles_..." and "contacts_...". The snapshot must live until
/// the checkpoint is written.
void put_snapshot(io::Checkpoint& checkpoint, const dem::Snapshot& snapshot);

/// The snapshot for System::restore(snapshot, reader.same_ranks()).
/// @param walls  as the case gives them at the start; those that move are put where they were
/// @throws RunError  when the file does not fit
[[nodiscard]] dem::Snapshot get_snapshot(const io::CheckpointReader& reader, dem::Surfaces walls);

}  // namespace porefines::sim
