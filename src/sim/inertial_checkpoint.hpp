// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include "io/provenance.hpp"
#include "sim/inertial_state.hpp"

namespace porefines::sim {

/// checkpoint.h5: the last two moments of the flow, by cells of the grid, and the counts of the run.
/// Collective.
void write_checkpoint(const InertialRun& run, const std::string& folder,
                      const io::Provenance& provenance);

/// Goes on from the newest one: bit for bit on as many ranks, to the solver's tolerance on others.
/// Collective. Test: cli/inertial.
void go_on(InertialRun& run, const std::string& folder);

}  // namespace porefines::sim
