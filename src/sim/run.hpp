// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include "config/case.hpp"

namespace porefines::sim {

/// What the command line says beside the case.
struct RunOptions {
  bool dry_run = false;    ///< print derived numbers and draw the geometry, solve nothing
  std::string output_dir;  ///< where everything is written; created when missing
  bool restart = false;    ///< continue from the checkpoint in output_dir
};

/// Simulates a case and writes its output folder. Collective over MPI_COMM_WORLD.
///
/// Leaves between two stages or cycles when a signal came since watch_signals(), says so, and writes
/// no results. One that comes when all results are written changes nothing.
///
/// @return  the exit code: exit_code::done, or exit_code::signal_base + n when signal n ended it
/// @throws InputError  the case cannot be run: nothing was
/// @throws RunError    the simulation stopped itself; what there is has been saved
[[nodiscard]] int run(const config::Case& the_case, const RunOptions& options);

}  // namespace porefines::sim
