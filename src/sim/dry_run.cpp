// SPDX-License-Identifier: MPL-2.0
#include "sim/dry_run.hpp"

#include <iostream>
#include <optional>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/progress.hpp"
#include "core/signals.hpp"
#include "sim/domain.hpp"
#include "sim/dry_checkpoint.hpp"
#include "sim/dry_output.hpp"
#include "sim/dry_results.hpp"
#include "sim/dry_state.hpp"
#include "sim/session.hpp"

namespace porefines::sim {
namespace {

/// The rows of the moment, the loop, and why it ended.
Outcome simulate(DryRun& run, Sink& sink, const Stopwatch& watch, Log& log) {
  const DryState& now = run.state;
  Keeper keeper(run.comm, run.the_case, watch, log, now.time,
                [&] { write_checkpoint(run, sink.folder, sink.provenance); });
  write_due(run, sink, "");
  while (now.time < run.the_case.run.end_time) {
    const Real start = now.time;
    advance(run, choose_stretch(run));       // contact, gravity, forces: Newton and Euler
    const std::string left = take_out(run);  // through open faces
    inject_due(run, start, now.time);        // through inlets
    now.ledger.require_balance(run.comm.sum(static_cast<Index>(run.system.particles().owned)),
                               now.time);
    require_healthy(run);        // overlaps within their bound
    write_due(run, sink, left);  // tracks, series
    if (const auto stop = keeper.after_step(now.time, now.steps)) {
      return *stop;
    }
  }
  keeper.save(now.time, now.steps);
  return {};
}

void write_results(const std::string& folder, const DryRun& run, const Outcome& outcome,
                   const io::Provenance& provenance) {
  if (config::find_output(run.the_case, config::OutputKind::pictures) != nullptr) {
    draw_dry(folder + "/particles.png", run, provenance);
  }
  const Json summary = summarise_dry(run, outcome.ending, provenance);
  on_root(run.comm, [&] { write_file(folder + "/summary.json", summary.text()); });
}

void say_result(Log& log, const DryRun& run, const Outcome& outcome, const std::string& folder) {
  const Moment now = look(run);
  say_particles(log, run);
  log.info("contacts   {:.3f} per particle, largest overlap {:.2g} of a radius", now.coordination,
           now.max_overlap);
  const dem::Spent& spent = now.totals.dissipated;
  log.info("energy     {:.4g} J kinetic, {:.4g} J elastic, {:.4g} J lost",
           now.totals.kinetic + now.totals.rotational, now.totals.elastic, now.energy_lost);
  log.info("dissipated {:.4g} J by damping, {:.4g} J by friction, {:.4g} J by rolling: {:.4g} J",
           spent.normal, spent.sliding, spent.rolling, now.dissipated);
  log.info("steps      {} in {:.3g} s", run.state.steps, outcome.ending.wall_time);
  log.info("results    {}", folder);
}

/// The particles of the start, or those of the checkpoint. @return remarks
std::vector<std::string> begin(DryRun& run, const RunOptions& options) {
  if (!options.restart) {
    return place_particles(run);
  }
  go_on(run, options.output_dir);
  return {fmt::format("as they were at {:.6g} s, step {}", run.state.time, run.state.steps)};
}

}  // namespace

int run_dry(const config::Case& the_case, const RunOptions& options,
            const par::Communicator& comm) {
  const Stopwatch watch;
  const io::Provenance provenance = io::make_provenance(comm.size(), the_case.run.random_seed);
  const geom::Sample sample = geom::build_sample(geometry_spec(the_case), comm.handle());
  DryRun run = make_dry_run(the_case, sample, comm);
  const std::string& folder = options.output_dir;
  const std::vector<std::string> remarks = begin(run, options);
  const std::vector<std::string> story = describe_dry(run, remarks);
  if (options.dry_run) {
    on_root(comm, [&] { make_folder(folder); });
    draw_dry(folder + "/particles.png", run, provenance);
    Log log("", comm.is_root() ? &std::cout : nullptr);
    say(log, comm, provenance, story);
    return exit_code::done;
  }
  const Start start = options.restart ? Start::resumed : Start::fresh;
  Log log = open_folder(folder, the_case, comm, start);
  say(log, comm, provenance, story);
  Sink sink = open_sink(folder, run, provenance, start);
  Outcome outcome = safely(folder, [&] { return simulate(run, sink, watch, log); });
  outcome.ending.wall_time = watch.seconds();
  write_rest(outcome, [&] {
    finish_movie(run, sink);
    write_results(folder, run, outcome, provenance);
    say_result(log, run, outcome, folder);
  });
  if (outcome.exit_code > exit_code::signal_base) {
    log.warn("stopped by {}: results are those so far", outcome.ending.reason);
  }
  return outcome.exit_code;
}

}  // namespace porefines::sim
