// SPDX-License-Identifier: MPL-2.0
#include "sim/coupled_run.hpp"

#include <fmt/format.h>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/memory.hpp"
#include "core/progress.hpp"
#include "core/signals.hpp"
#include "sim/coupled_checkpoint.hpp"
#include "sim/coupled_output.hpp"
#include "sim/dry_results.hpp"
#include "sim/ending.hpp"
#include "sim/grains.hpp"
#include "sim/pictures.hpp"
#include "sim/prepare.hpp"
#include "sim/results.hpp"
#include "sim/session.hpp"

namespace porefines::sim {
namespace {

Outcome simulate(CoupledRun& run, CoupledSink& sink, std::span<const float> solid,
                 const Stopwatch& watch, Log& log) {
  std::optional<Progress> progress;
  if (run.comm().is_root()) {
    progress.emplace("run");
  }
  const auto save = [&](Real wall_time) {
    sim::save(run.particles, sink.tables, wall_time, log,
              [&] { write_checkpoint(run, sink.tables.folder, sink.tables.provenance); });
  };
  const Real end = run.the_case.run.end_time;
  std::string left;
  while (true) {
    solve_flow(run);                        // fluid and rigid particles in one system
    write_coupled(run, sink, left, solid);  // of this moment
    look_at_limits(run);
    if (run.time() >= end || run.state.stopped) {
      save(run.comm().max(watch.seconds()));
      return {.ending = {.reason = run.state.reason}};
    }
    const Real step = choose_step(run);
    move_particles(run, step);        // with the flow and against each other
    left = pass_openings(run, step);  // out, and in
    require_healthy(run.particles);   // overlaps within their bound
    if (progress) {
      progress->update(run.time() / end);
    }
    const Real wall_time = run.comm().max(watch.seconds());
    if (const auto stop = reason_to_stop(run.particles, wall_time)) {
      save(wall_time);
      return *stop;
    }
    if (wall_time - sink.tables.saved >= run.the_case.checkpoint.every) {
      save(wall_time);
    }
  }
}

void say_coupled(Log& log, const CoupledRun& run, const Outcome& outcome) {
  say_particles(log, run.particles);
  log.info("k/k0       {:.4f} after {:.4g} pore volumes", run.permeability_ratio(),
           run.pore_volumes());
  log.info("steps      {} to {:.4g} s, {:.3g} cycles per solve, {} contact substeps",
           run.particles.state.steps, run.time(),
           static_cast<Real>(run.state.cycles) / static_cast<Real>(run.state.solves),
           run.state.substeps);
  if (!outcome.ending.reason.empty()) {
    log.info("ended      {}", outcome.ending.reason);
  }
}

/// Pictures of the last moment. Collective.
void draw_end(CoupledRun& run, const std::string& folder, const geom::Sample& sample,
              std::span<const float> solid, const io::Provenance& provenance) {
  if (config::find_output(run.the_case, config::OutputKind::pictures) == nullptr) {
    return;
  }
  draw_dry(folder + "/particles.png", run.particles, provenance);
  draw_fields(folder, run.the_case, sample, run.domain, cell_fields(run), solid, run.solver.block(),
              provenance, run.comm());
}

}  // namespace

int run_coupled_case(const config::Case& the_case, const RunOptions& options,
                     const par::Communicator& comm, std::optional<Log>& log) {
  const Stopwatch watch;
  const io::Provenance provenance = io::make_provenance(comm.size(), the_case.run.random_seed);
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
  log->info("set-up     {:.2g} s", watch.seconds());
  const SteadyFlow clean = solve_steady_flow(the_case, domain, solver, comm);
  if (clean.signal != 0) {
    throw Interrupted{clean.signal};
  }
  log->info("clean k    {:.5g} m^2 = {:.5g} darcy", clean.permeability, clean.permeability / darcy);
  RunFacts facts;
  facts.porosity = measure_porosity(prepared.sample, domain, solver.block(), solid, comm);
  facts.fluid_cells = solver.fluid_cells();
  facts.plan = prepared.plan;
  facts.provenance = provenance;

  const config::Case boxed = with_box_of_flow(the_case);
  CoupledRun run = make_coupled_run(boxed, prepared.sample, domain, prepared.cut, solver, clean,
                                    facts.porosity.connected, comm);
  if (options.restart) {
    go_on(run, folder);
    log->info("goes on at {:.6g} s, step {}", run.time(), run.particles.state.steps);
  } else {
    for (const std::string& remark : place_particles(run.particles)) {
      log->info("{}", remark);
    }
    run.particles.system.start_creeping();
  }
  CoupledSink sink = open_coupled_sink(folder, run, provenance, start);
  const Outcome outcome = safely([&] { return simulate(run, sink, solid, watch, *log); });
  draw_end(run, folder, prepared.sample, solid, provenance);
  facts.peak_memory = comm.sum(static_cast<Real>(peak_memory()));
  facts.wall_time = watch.seconds();
  Json summary = summarise(the_case, prepared.sample, domain, clean, facts);
  add_coupled(summary, run);
  summary.set("status", outcome.ending.status);
  if (!outcome.ending.reason.empty()) {
    summary.set("reason", outcome.ending.reason);
  }
  on_root(comm, [&] { write_file(folder + "/summary.json", summary.text()); });
  say_coupled(*log, run, outcome);
  log->info("results    {}", folder);
  if (!outcome.error.empty()) {
    throw RunError(outcome.error);
  }
  return outcome.exit_code;
}

}  // namespace porefines::sim
