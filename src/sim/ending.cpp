// SPDX-License-Identifier: MPL-2.0
#include "sim/ending.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "sim/session.hpp"

namespace porefines::sim {

std::optional<Outcome> reason_to_stop(const DryRun& run, Real wall_time) {
  if (const int signal = signal_anywhere(run.comm); signal != 0) {
    return Outcome{
        {"interrupted", fmt::format("signal {}", signal)}, exit_code::signal_base + signal, ""};
  }
  const Real limit = run.the_case.run.max_wall;
  if (limit > 0 && wall_time > limit) {
    return Outcome{{"stopped", "max_wall"},
                   exit_code::stopped_itself,
                   fmt::format("run.max_wall is over at {:.6g} s of {:.6g} s; results are those so "
                               "far, and --restart goes on",
                               run.state.time, run.the_case.run.end_time)};
  }
  return {};
}

std::string way_on(const std::string& folder) {
  const std::string checkpoint = folder + "/checkpoint.h5";
  return std::filesystem::exists(checkpoint)
             ? fmt::format("\n--restart goes on from {}, once the cause is mended", checkpoint)
             : "";
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
