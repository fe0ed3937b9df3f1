// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "config/case.hpp"
#include "par/communicator.hpp"
#include "sim/run.hpp"

namespace porefines::sim {

/// Particles without a fluid: settling, hoppers, inclines, packings. Collective.
///
/// Writes tracks.csv, series.csv, particles.png and summary.json. A signal, the limit on wall time
/// and an error each leave the results so far.
/// @return exit code; InputError and RunError as run()
/// Tests: cli/dry_cases, cli/wrong_particles.
[[nodiscard]] int run_dry(const config::Case& the_case, const RunOptions& options,
                          const par::Communicator& comm);

}  // namespace porefines::sim
