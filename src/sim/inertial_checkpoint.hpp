// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include "io/checkpoint.hpp"
#include "io/provenance.hpp"
#include "sim/inertial_state.hpp"

namespace porefines::sim {

/// What a flow goes on from, by cells of the grid. The memory must live until the checkpoint is written.
void put_flow(io::Checkpoint& checkpoint, const flow::InertialFlow::Memory& memory,
              const io::GridBlock& grid);
[[nodiscard]] flow::InertialFlow::Memory get_flow(const io::CheckpointReader& reader,
                                                  const io::GridBlock& grid);

/// checkpoint.h5: the last two moments of the flow, by cells of the grid, and the counts of the run.
/// Collective.
void write_checkpoint(const InertialRun& run, const std::string& folder,
                      const io::Provenance& provenance);

/// Goes on from the newest one: bit for bit on as many ranks, to the solver's tolerance on others.
/// Collective. Test: cli/inertial.
void go_on(InertialRun& run, const std::string& folder);

}  // namespace porefines::sim
