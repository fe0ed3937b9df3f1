// SPDX-License-Identifier: MPL-2.0
#include "sim/dry_run.hpp"

#include <iostream>
#include <optional>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/progress.hpp"
#include "core/signals.hpp"
#include "io/series.hpp"
#include "sim/domain.hpp"
#include "sim/dry_results.hpp"
#include "sim/dry_state.hpp"
#include "sim/particle_setup.hpp"
#include "sim/session.hpp"
#include "sim/tracks.hpp"

namespace porefines::sim {
namespace {

/// Where results go; the tables are open on rank 0 alone.
struct Sink {
  std::string folder;
  io::Provenance provenance;
  std::optional<io::SeriesWriter> series;
  std::optional<io::SeriesWriter> tracks;
};

Sink open_sink(const std::string& folder, const DryRun& run, const io::Provenance& provenance) {
  Sink sink{folder, provenance, {}, {}};
  on_root(run.comm, [&] {
    sink.series.emplace(folder + "/series.csv", series_columns());
    if (const auto* output = config::find_output(run.the_case, config::OutputKind::tracks)) {
      sink.tracks.emplace(folder + "/tracks.csv", track_columns(output->forces));
    }
  });
  return sink;
}

/// Is the next sample of this output now?
bool is_due(const DryRun& run, config::OutputKind kind, Index written) {
  const Real due = static_cast<Real>(written) * sample_interval(run.the_case, kind);
  return is_sampled(run.the_case, kind) && run.state.time >= due * (1 - 1e-12);
}

/// @param left  rows of those that left, for tracks.csv
void write_due(DryRun& run, Sink& sink, const std::string& left) {
  std::string rows = left;
  if (is_due(run, config::OutputKind::tracks, run.state.tracked)) {
    rows += track_rows(run);
    ++run.state.tracked;
  }
  std::optional<Moment> now;
  if (is_due(run, config::OutputKind::summary, run.state.samples)) {
    now = look(run);
    ++run.state.samples;
  }
  on_root(run.comm, [&] {
    if (sink.tracks && !rows.empty()) {
      sink.tracks->append_lines(rows);
    }
    if (now) {
      sink.series->append(series_row(run, *now));
    }
  });
  if (is_due(run, config::OutputKind::pictures, run.state.drawn)) {
    draw_dry(fmt::format("{}/particles_{:05}.png", sink.folder, run.state.drawn), run,
             sink.provenance);
    ++run.state.drawn;
  }
}

/// What ended the loop.
struct Outcome {
  Ending ending;
  int exit_code = exit_code::done;
  std::string error;  ///< to throw when everything is written
};

/// The rows of the moment, the loop, and why it ended.
Outcome simulate(DryRun& run, Sink& sink, const Stopwatch& watch) {
  std::optional<Progress> progress;
  if (run.comm.is_root()) {
    progress.emplace("run");
  }
  write_due(run, sink, "");
  const Real end = run.the_case.run.end_time;
  while (run.state.time < end) {
    const Real start = run.state.time;
    advance(run, choose_stretch(run));       // contact, gravity, forces: Newton and Euler
    const std::string left = take_out(run);  // through open faces
    inject_due(run, start, run.state.time);  // through inlets
    run.state.ledger.require_balance(run.comm.sum(static_cast<Index>(run.system.particles().owned)),
                                     run.state.time);
    require_healthy(run);        // overlaps within their bound
    write_due(run, sink, left);  // tracks, series
    if (progress) {
      progress->update(run.state.time / end);
    }
    if (const int signal = signal_anywhere(run.comm); signal != 0) {
      return {
          {"interrupted", fmt::format("signal {}", signal)}, exit_code::signal_base + signal, ""};
    }
    const Real limit = run.the_case.run.max_wall;
    if (limit > 0 && run.comm.max(watch.seconds()) > limit) {
      return {{"stopped", "max_wall"},
              exit_code::stopped_itself,
              fmt::format("run.max_wall is over at {:.6g} s of {:.6g} s; results are those so far",
                          run.state.time, end)};
    }
  }
  return {};
}

/// The same, with errors as an ending: what there is will be written before they are reported.
Outcome simulate_safely(DryRun& run, Sink& sink, const Stopwatch& watch) {
  std::string error;
  Outcome outcome;
  try {
    outcome = simulate(run, sink, watch);
  } catch (const RunError& failure) {
    error = failure.what();
  }
  if (!error.empty()) {
    return {{"stopped", error}, exit_code::stopped_itself, error};
  }
  return outcome;
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
  const Ledger& ledger = run.state.ledger;
  log.info("particles  {} placed + {} injected = {} inside + {} out", ledger.placed,
           ledger.injected, now.totals.particles, ledger.out);
  for (std::size_t k = 0; k < run.inlets.size(); ++k) {
    if (run.state.inlets[k].waiting > 0) {
      log.warn("{}: {} particles were due but found no room at the inlet",
               run.the_case.injection[k].species, run.state.inlets[k].waiting);
    }
  }
  log.info("contacts   {:.3f} per particle, largest overlap {:.2g} of a radius", now.coordination,
           now.max_overlap);
  log.info("energy     {:.4g} J kinetic, {:.4g} J elastic, {:.4g} J lost",
           now.totals.kinetic + now.totals.rotational, now.totals.elastic, now.energy_lost);
  log.info("steps      {} in {:.3g} s", run.state.steps, outcome.ending.wall_time);
  log.info("results    {}", folder);
}

}  // namespace

int run_dry(const config::Case& the_case, const RunOptions& options,
            const par::Communicator& comm) {
  const Stopwatch watch;
  const io::Provenance provenance = io::make_provenance(comm.size(), the_case.run.random_seed);
  if (options.restart) {
    throw InputError("this version writes no checkpoint of particles: run it without --restart");
  }
  const geom::Sample sample = geom::build_sample(geometry_spec(the_case), comm.handle());
  std::vector<std::string> remarks;
  DryRun run = make_dry_run(the_case, sample, comm, remarks);
  const std::vector<std::string> story = describe_dry(run, remarks);
  const std::string& folder = options.output_dir;
  if (options.dry_run) {
    on_root(comm, [&] { make_folder(folder); });
    draw_dry(folder + "/particles.png", run, provenance);
    Log log("", comm.is_root() ? &std::cout : nullptr);
    say(log, comm, provenance, story);
    return exit_code::done;
  }
  Log log = open_folder(folder, the_case, comm);
  say(log, comm, provenance, story);
  Sink sink = open_sink(folder, run, provenance);
  Outcome outcome = simulate_safely(run, sink, watch);
  outcome.ending.wall_time = watch.seconds();
  write_results(folder, run, outcome, provenance);
  say_result(log, run, outcome, folder);
  if (!outcome.error.empty()) {
    throw RunError(outcome.error);
  }
  if (outcome.exit_code > exit_code::signal_base) {
    log.warn("stopped by {}: results are those so far", outcome.ending.reason);
  }
  return outcome.exit_code;
}

}  // namespace porefines::sim
