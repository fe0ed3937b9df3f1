// SPDX-License-Identifier: MPL-2.0
// How runs in time come to their end.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/error.hpp"
#include "core/json.hpp"
#include "core/log.hpp"
#include "core/progress.hpp"
#include "sim/dry_state.hpp"
#include "sim/session.hpp"

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

/// Watches over a loop: progress, checkpoints, and when to leave it.
class Keeper {
 public:
  /// @param from   [s] simulated time at which the loop begins: above 0 after a restart
  /// @param write  writes a checkpoint; collective
  Keeper(const par::Communicator& comm, const config::Case& the_case, const Stopwatch& watch,
         Log& log, Real from, std::function<void()> write);

  /// After a step. @return  why to leave, with a checkpoint written: a signal, or run.max_wall.
  /// Collective.
  [[nodiscard]] std::optional<Outcome> after_step(Real time, Index steps);
  /// A failure is a warning, since the run has its worth without. Collective.
  void save(Real time, Index steps);

 private:
  [[nodiscard]] std::optional<Outcome> reason_to_stop(Real time, Real wall_time) const;

  const par::Communicator& comm_;
  const config::Case& the_case_;
  const Stopwatch& watch_;
  Log& log_;
  std::function<void()> write_;
  std::optional<Progress> progress_;  ///< rank 0
  Real saved_ = 0;                    ///< [s] of wall time at the last checkpoint
};

/// What to do after an error: "" where there is no checkpoint.
[[nodiscard]] std::string way_on(const std::string& folder);

/// Runs a loop with errors as an ending: what there is will be written before they are reported.
template <typename Simulate>
[[nodiscard]] Outcome safely(const std::string& folder, const Simulate& simulate) {
  std::string error;
  try {
    return simulate();
  } catch (const RunError& failure) {
    error = failure.what();
  }
  return {{"stopped", error}, exit_code::stopped_itself, error + way_on(folder)};
}

/// Writes the rest; after an error, as much of it as can be, and then the error goes on.
/// @throws RunError  of the outcome
template <typename Write>
void write_rest(const Outcome& outcome, const Write& write) {
  if (outcome.error.empty()) {
    write();
    return;
  }
  try {
    write();
  } catch (const RunError&) {
    // What ended the run, such as a full disk, says more.
  }
  throw RunError(outcome.error);
}

/// summary.json with how it ended. Collective.
void write_summary(const std::string& folder, Json summary, const Ending& ending,
                   const par::Communicator& comm);

/// The ledger, and what found no room at an inlet.
void say_particles(Log& log, const DryRun& run);

}  // namespace porefines::sim
