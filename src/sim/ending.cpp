// SPDX-License-Identifier: MPL-2.0
#include "sim/ending.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "core/atomic_file.hpp"

namespace porefines::sim {

Keeper::Keeper(const par::Communicator& comm, const config::Case& the_case, const Stopwatch& watch,
               Log& log, Real from, std::function<void()> write)
    : comm_(comm), the_case_(the_case), watch_(watch), log_(log), write_(std::move(write)) {
  if (comm.is_root()) {
    progress_.emplace("run");
    progress_->start_from(from / the_case.run.end_time);
  }
}

std::optional<Outcome> Keeper::after_step(Real time, Index steps) {
  if (progress_) {
    progress_->update(time / the_case_.run.end_time);
  }
  const Real wall_time = comm_.max(watch_.seconds());
  std::optional<Outcome> stop = reason_to_stop(time, wall_time);
  if (stop || wall_time - saved_ >= the_case_.checkpoint.every) {
    save(time, steps);
  }
  return stop;
}

void Keeper::save(Real time, Index steps) {
  saved_ = comm_.max(watch_.seconds());
  try {
    write_();
    log_.info("checkpoint at {:.9g} s, step {}", time, steps);
  } catch (const RunError& failure) {
    log_.warn("no checkpoint at {:.6g} s: {}", time, failure.what());
  }
}

std::optional<Outcome> Keeper::reason_to_stop(Real time, Real wall_time) const {
  if (const int signal = signal_anywhere(comm_); signal != 0) {
    return Outcome{
        {"interrupted", fmt::format("signal {}", signal)}, exit_code::signal_base + signal, ""};
  }
  const Real limit = the_case_.run.max_wall;
  if (limit > 0 && wall_time > limit) {
    return Outcome{{"stopped", "max_wall"},
                   exit_code::stopped_itself,
                   fmt::format("run.max_wall is over at {:.6g} s of {:.6g} s; results are those so "
                               "far, and --restart goes on",
                               time, the_case_.run.end_time)};
  }
  return {};
}

std::string way_on(const std::string& folder) {
  const std::string checkpoint = folder + "/checkpoint.h5";
  return std::filesystem::exists(checkpoint)
             ? fmt::format("\n--restart goes on from {}, once the cause is mended", checkpoint)
             : "";
}

void write_summary(const std::string& folder, Json summary, const Ending& ending,
                   const par::Communicator& comm) {
  summary.set("status", ending.status);
  if (!ending.reason.empty()) {
    summary.set("reason", ending.reason);
  }
  on_root(comm, [&] { write_file(folder + "/summary.json", summary.text()); });
}

void say_particles(Log& log, const DryRun& run) {
  const Ledger& ledger = run.state.ledger;
  log.info("particles  {} placed + {} injected = {} inside + {} out", ledger.placed,
           ledger.injected, ledger.expected_inside(), ledger.out);
  for (std::size_t k = 0; k < run.inlets.size(); ++k) {
    if (run.state.inlets[k].waiting > 0) {
      log.warn("{}: {} particles were due but found no room at the inlet",
               run.the_case.injection[k].species, run.state.inlets[k].waiting);
    }
  }
}

}  // namespace porefines::sim
