// SPDX-License-Identifier: MPL-2.0
// How runs with particles come to their end.
#pragma once

#include <optional>
#include <string>

#include "core/error.hpp"
#include "core/log.hpp"
#include "sim/dry_state.hpp"

namespace porefines::sim {

/// What the summary says of it.
struct Ending {
  std::string status = "done";  ///< done, interrupted, stopped
  std::string reason = "";
  Real wall_time = 0;  ///< [s]
};

/// What ended the loop.
struct Outcome {
  Ending ending = {};
  int exit_code = exit_code::done;
  std::string error = "";  ///< to throw when everything is written
};

/// Is it time to leave: a signal, or run.max_wall? Collective.
/// @param wall_time  [s] of the slowest rank
[[nodiscard]] std::optional<Outcome> reason_to_stop(const DryRun& run, Real wall_time);

/// What to do after an error: "" where there is no checkpoint.
[[nodiscard]] std::string way_on(const std::string& folder);

/// Writes the rest; after an error, as much of it as can be, and then the error goes on.
/// @throws RunError  of the outcome, with the way on
template <typename Write>
void write_rest(const Outcome& outcome, const std::string& folder, const Write& write) {
  if (outcome.error.empty()) {
    write();
    return;
  }
  try {
    write();
  } catch (const RunError&) {
    // What ended the run, such as a full disk, says more.
  }
  throw RunError(outcome.error + way_on(folder));
}

/// Runs a loop with errors as an ending: what there is will be written before they are reported.
template <typename Simulate>
[[nodiscard]] Outcome safely(const Simulate& simulate) {
  std::string error;
  try {
    return simulate();
  } catch (const RunError& failure) {
    error = failure.what();
  }
  return {{"stopped", error}, exit_code::stopped_itself, error};
}

/// The ledger, and what found no room at an inlet.
void say_particles(Log& log, const DryRun& run);

}  // namespace porefines::sim
