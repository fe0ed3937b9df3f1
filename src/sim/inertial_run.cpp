// SPDX-License-Identifier: MPL-2.0
#include "sim/inertial_run.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/progress.hpp"
#include "core/signals.hpp"
#include "sim/ending.hpp"
#include "sim/grains.hpp"
#include "sim/inertial_checkpoint.hpp"
#include "sim/inertial_output.hpp"
#include "sim/inertial_setup.hpp"
#include "sim/pictures.hpp"
#include "sim/prepare.hpp"
#include "sim/results.hpp"
#include "sim/session.hpp"

namespace porefines::sim {
namespace {

Outcome march(InertialRun& run, InertialSink& sink, std::span<const float> solid,
              const Stopwatch& watch, Log& log) {
  Keeper keeper(run.comm, run.the_case, watch, log, run.flow->time(),
                [&] { write_checkpoint(run, sink.folder, sink.provenance); });
  write_inertial(run, sink, solid);
  while (run.flow->time() < run.the_case.run.end_time * (1 - 1e-12)) {
    advance(run, choose_step(run));
    write_inertial(run, sink, solid);
    if (const auto stop = keeper.after_step(run.flow->time(), run.state.steps)) {
      return *stop;
    }
  }
  keeper.save(run.flow->time(), run.state.steps);
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
  const DarcyFlow now = measure_darcy(run.the_case, run.domain, run.drive, run.solver);
  SteadyFlow out;
  out.flow_rate = now.flow_rate;
  out.flux_variation = now.flux_variation;
  out.velocity = run.solver.superficial_velocity();
  out.solve.cycles = static_cast<int>(run.state.cycles);
  out.pressure_drop = out.total_drop = now.pressure_drop;
  out.permeability = now.pressure_drop != 0 ? now.permeability : 0;
  return out;
}

/// Fields of a steady flow, pictures, summary.json, and what a person reads. Collective.
void write_results(InertialRun& run, const Prepared& prepared, std::span<const float> solid,
                   RunFacts facts, const std::string& folder, const Outcome& outcome,
                   const Stopwatch& watch, Log& log) {
  const auto asks = [&](config::OutputKind kind) {
    return config::find_output(run.the_case, kind) != nullptr;
  };
  const bool fields_now =
      run.the_case.inertia.steady && outcome.error.empty() && asks(config::OutputKind::fields);
  if (fields_now || asks(config::OutputKind::pictures)) {
    const auto fields = case_fields(run.solver, 1, run.offset);
    if (fields_now) {
      io::FieldWriter writer =
          open_fields(folder, run.domain, run.solver.block(), facts.provenance, run.comm);
      write_fields(writer, 0, fields, solid);
    }
    if (asks(config::OutputKind::pictures)) {
      draw_fields(folder, run.the_case, run.sample, run.domain, fields, solid, run.solver.block(),
                  facts.provenance, run.comm);
    }
  }
  take_cost(facts, watch, run.comm);
  const SteadyFlow now = measure(run);
  Json summary = summarise(run.the_case, prepared.sample, run.domain, now, facts);
  add_inertial(summary, run, folder);
  write_summary(folder, std::move(summary), outcome.ending, run.comm);
  log.info("flow       {:.4g} m^3/s, {:.4g} Pa over the sample", now.flow_rate, now.pressure_drop);
  log.info(
      "steps      {} to {:.4g} s, {:.3g} cycles each", run.state.steps, run.flow->time(),
      static_cast<Real>(run.state.cycles) / static_cast<Real>(std::max<Index>(run.state.steps, 1)));
  log.info("results    {}", folder);
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
  const config::Case told = with_velocities(the_case, domain);
  InertialRun run = make_inertial_run(told, prepared.sample, domain, solver, comm);
  log->info("set-up     {:.2g} s", watch.seconds());
  if (options.restart) {
    go_on(run, folder);
    log->info("goes on at {:.6g} s, step {}", run.flow->time(), run.state.steps);
  }
  InertialSink sink = steady ? InertialSink{folder, provenance}
                             : open_inertial_sink(folder, run, provenance, start);
  const Outcome outcome = safely(
      folder, [&] { return steady ? settle(run, *log) : march(run, sink, solid, watch, *log); });
  const RunFacts facts = facts_of(prepared, solver, solid, provenance, comm);
  write_rest(outcome,
             [&] { write_results(run, prepared, solid, facts, folder, outcome, watch, *log); });
  return outcome.exit_code;
}

}  // namespace porefines::sim
