// SPDX-License-Identifier: MPL-2.0
#include "sim/inertial_run.hpp"

#include <cmath>

#include <fmt/format.h>

#include "analysis/flux.hpp"
#include "analysis/permeability.hpp"
#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/memory.hpp"
#include "core/progress.hpp"
#include "core/signals.hpp"
#include "sim/ending.hpp"
#include "sim/grains.hpp"
#include "sim/inertial_checkpoint.hpp"
#include "sim/inertial_output.hpp"
#include "sim/pictures.hpp"
#include "sim/prepare.hpp"
#include "sim/results.hpp"
#include "sim/session.hpp"

namespace porefines::sim {
namespace {

void save(const InertialRun& run, InertialSink& sink, Real wall_time, Log& log) {
  sink.saved = wall_time;
  try {
    write_checkpoint(run, sink.folder, sink.provenance);
    log.info("checkpoint at {:.9g} s, step {}", run.flow->time(), run.state.steps);
  } catch (const RunError& failure) {
    log.warn("no checkpoint at {:.6g} s: {}", run.flow->time(), failure.what());
  }
}

/// A signal on any rank, or run.max_wall. Collective.
std::optional<Outcome> reason_to_leave(const InertialRun& run, Real wall_time) {
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
                               run.flow->time(), run.the_case.run.end_time)};
  }
  return {};
}

Outcome march(InertialRun& run, InertialSink& sink, std::span<const float> solid,
              const Stopwatch& watch, Log& log) {
  std::optional<Progress> progress;
  if (run.comm.is_root()) {
    progress.emplace("run");
  }
  const Real end = run.the_case.run.end_time;
  write_inertial(run, sink, solid);
  while (run.flow->time() < end * (1 - 1e-12)) {
    advance(run, choose_step(run));
    write_inertial(run, sink, solid);
    if (progress) {
      progress->update(run.flow->time() / end);
    }
    const Real wall_time = run.comm.max(watch.seconds());
    if (const auto stop = reason_to_leave(run, wall_time)) {
      save(run, sink, wall_time, log);
      return *stop;
    }
    if (wall_time - sink.saved >= run.the_case.checkpoint.every) {
      save(run, sink, wall_time, log);
    }
  }
  save(run, sink, run.comm.max(watch.seconds()), log);
  return {};
}

/// The steady flow in one go.
Outcome settle(InertialRun& run, Log& log) {
  constexpr int most_steps = 5000;
  int signal = 0;
  flow::StepOptions options;
  options.tolerance = run.the_case.flow.tolerance;
  options.max_cycles = 60;  // per step: they shrink where that is not enough
  options.interrupted = [&] {
    signal = signal_anywhere(run.comm);
    return signal != 0;
  };
  const auto report = run.flow->settle(run.drive, options, most_steps);
  run.state.steps = report.steps;
  run.state.cycles = report.cycles;
  if (signal != 0) {
    throw Interrupted{signal};
  }
  if (!report.converged) {
    throw RunError(
        fmt::format("the flow did not become steady: it still changes by {:.3g} of itself while it "
                    "crosses a cell, after {} steps, wanted {:.3g}\n"
                    "perhaps there is no steady flow: take steady = false and an end_time",
                    report.residual, report.steps, options.tolerance));
  }
  log.info("steady     after {} steps, {} cycles", report.steps, report.cycles);
  return {};
}

/// Flow rate and pressures of the moment, in the words of the creeping flow.
SteadyFlow measure(const InertialRun& run) {
  SteadyFlow out;
  const std::vector<Real> fluxes = run.solver.plane_fluxes(run.domain.axis);
  out.flow_rate = analysis::mean(fluxes);
  out.flux_variation = analysis::flux_variation(fluxes);
  out.velocity = run.solver.superficial_velocity();
  out.solve.cycles = static_cast<int>(run.state.cycles);
  if (run.the_case.flow.inlet) {
    out.pressure_drop = sample_pressure_drop(run.domain, run.drive, run.solver);
  } else {
    out.pressure_drop = run.drive.force[run.domain.axis] * run.domain.length();
  }
  out.total_drop = out.pressure_drop;
  if (out.pressure_drop != 0) {
    out.permeability =
        analysis::darcy_permeability({out.flow_rate, run.domain.area(), run.domain.length(),
                                      out.pressure_drop, run.the_case.fluid.viscosity});
  }
  return out;
}

void draw_end(InertialRun& run, const std::string& folder, std::span<const float> solid,
              const io::Provenance& provenance) {
  if (config::find_output(run.the_case, config::OutputKind::pictures) != nullptr) {
    draw_fields(folder, run.the_case, run.sample, run.domain, cell_fields(run), solid,
                run.solver.block(), provenance, run.comm);
  }
}

}  // namespace

int run_inertial_case(const config::Case& the_case, const RunOptions& options,
                      const par::Communicator& comm, std::optional<Log>& log) {
  const Stopwatch watch;
  const bool steady = the_case.inertia.steady;
  const io::Provenance provenance = io::make_provenance(comm.size(), the_case.run.random_seed);
  if (options.restart && steady) {
    throw InputError("a steady run has no checkpoint to restart from: run it without --restart");
  }
  const Prepared prepared = prepare(the_case, comm);
  const Domain& domain = prepared.domain;
  if (options.dry_run) {
    show_plan(the_case, options, prepared, provenance, comm);
    return exit_code::done;
  }
  const std::string& folder = options.output_dir;
  const Start start = options.restart ? Start::resumed : Start::fresh;
  log.emplace(open_folder(folder, the_case, comm, start));
  say(*log, comm, provenance, prepared.story);

  flow::StokesSolver solver(comm, prepared.cut, domain.spacing, domain.boundaries,
                            the_case.fluid.viscosity);
  const std::vector<float> solid = set_up(solver, the_case, prepared, comm);
  InertialRun run = make_inertial_run(the_case, prepared.sample, domain, solver, comm);
  log->info("set-up     {:.2g} s", watch.seconds());
  if (options.restart) {
    go_on(run, folder);
    log->info("goes on at {:.6g} s, step {}", run.flow->time(), run.state.steps);
  }
  InertialSink sink = steady ? InertialSink{folder, provenance}
                             : open_inertial_sink(folder, run, provenance, start);
  const Outcome outcome =
      safely([&] { return steady ? settle(run, *log) : march(run, sink, solid, watch, *log); });
  if (steady && outcome.error.empty() &&
      config::find_output(the_case, config::OutputKind::fields) != nullptr) {
    io::FieldWriter writer = open_fields(folder, domain, solver.block(), provenance, comm);
    write_fields(writer, 0, cell_fields(run), solid);
  }
  draw_end(run, folder, solid, provenance);

  RunFacts facts;
  facts.porosity = measure_porosity(prepared.sample, domain, solver.block(), solid, comm);
  facts.fluid_cells = solver.fluid_cells();
  facts.peak_memory = comm.sum(static_cast<Real>(peak_memory()));
  facts.plan = prepared.plan;
  facts.wall_time = watch.seconds();
  facts.provenance = provenance;
  const SteadyFlow now = measure(run);
  Json summary = summarise(the_case, prepared.sample, domain, now, facts);
  add_inertial(summary, run, folder);
  summary.set("status", outcome.ending.status);
  if (!outcome.ending.reason.empty()) {
    summary.set("reason", outcome.ending.reason);
  }
  on_root(comm, [&] { write_file(folder + "/summary.json", summary.text()); });
  log->info("flow       {:.4g} m^3/s, {:.4g} Pa over the sample", now.flow_rate, now.pressure_drop);
  log->info(
      "steps      {} to {:.4g} s, {:.3g} cycles each", run.state.steps, run.flow->time(),
      static_cast<Real>(run.state.cycles) / static_cast<Real>(std::max<Index>(run.state.steps, 1)));
  log->info("results    {}", folder);
  if (!outcome.error.empty()) {
    throw RunError(outcome.error);
  }
  return outcome.exit_code;
}

}  // namespace porefines::sim
