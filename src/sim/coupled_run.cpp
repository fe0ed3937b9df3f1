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

/// The end of the case, one of its limits, a signal, or run.max_wall. Collective.
std::optional<Outcome> reason_to_end(const CoupledRun& run, Real wall_time) {
  const std::string limit = limit_reached(run);
  if (!limit.empty() || run.time() >= run.the_case.run.end_time) {
    return Outcome{.ending = {.reason = limit}};
  }
  return reason_to_stop(run.particles, wall_time);
}

Outcome simulate(CoupledRun& run, CoupledSink& sink, const RunCanvas& canvas,
                 std::span<const float> solid, const Stopwatch& watch, Log& log) {
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
  if (run.cold) {
    solve_flow(run);
  }
  while (true) {
    write_coupled(run, sink, left, canvas, solid);  // of this moment
    const Real wall_time = run.comm().max(watch.seconds());
    if (const auto stop = reason_to_end(run, wall_time)) {
      save(wall_time);
      return *stop;
    }
    if (wall_time - sink.tables.saved >= run.the_case.checkpoint.every) {
      save(wall_time);
    }
    const Real step = choose_step(run);
    move_particles(run, step);        // with the flow and against each other
    stiffen_contacts(run);            // before overlaps reach their bound
    left = pass_openings(run, step);  // out, and in
    require_healthy(run.particles);   // overlaps within their bound
    solve_flow(run);                  // fluid and rigid particles in one system
    if (progress) {
      progress->update(run.time() / end);
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

/// "clogging   3 throats clogged; of all fines 80 % pipe, ..."
void say_fates(Log& log, const analysis::CloggingState& clogging) {
  const analysis::FateCounts& c = clogging.counts;
  const auto percent = [&](Index count) { return 100 * c.share(count); };
  log.info(
      "clogging   {} throats clogged; of all fines {:.3g} % pipe or have left, {:.3g} % bridge, "
      "{:.3g} % are held, {:.3g} % rest",
      clogging.clogs.size(), percent(c.piping), percent(c.bridging), percent(c.clogged),
      percent(c.resting));
}

/// The sample and its flow before the first particle.
struct Scene {
  const config::Case& the_case;
  const Prepared& prepared;
  std::vector<float> solid;  ///< share of each cell that is grain
  SteadyFlow clean;
  RunCanvas canvas;
  RunFacts facts;
};

/// Links the grains and solves the clean flow. Collective.
Scene set_scene(const config::Case& the_case, const Prepared& prepared, flow::StokesSolver& solver,
                const par::Communicator& comm, const Stopwatch& watch, Log& log) {
  Scene scene{the_case, prepared, set_up(solver, the_case, prepared, comm), {}, {}, {}};
  log.info("set-up     {:.2g} s", watch.seconds());
  const Domain& domain = prepared.domain;
  scene.clean = solve_steady_flow(the_case, domain, solver, comm);
  const SteadyFlow& clean = scene.clean;
  if (clean.signal != 0) {
    throw Interrupted{clean.signal};
  }
  log.info("clean k    {:.5g} m^2 = {:.5g} darcy", clean.permeability, clean.permeability / darcy);
  flow::StokesSolver::CellFields fields = solver.cell_fields();
  to_case_units(fields, clean.scale, clean.offset);
  scene.canvas = make_canvas(domain, prepared.sample, fields, scene.solid, solver.block(), comm);
  scene.facts.porosity =
      measure_porosity(prepared.sample, domain, solver.block(), scene.solid, comm);
  scene.facts.fluid_cells = solver.fluid_cells();
  scene.facts.plan = prepared.plan;
  return scene;
}

/// Particles of the start, or of the checkpoint. Collective.
void begin(CoupledRun& run, const RunOptions& options, Log& log) {
  if (options.restart) {
    go_on(run, options.output_dir);
    log.info("goes on at {:.6g} s, step {}", run.time(), run.particles.state.steps);
    return;
  }
  for (const std::string& remark : place_particles(run.particles)) {
    log.info("{}", remark);
  }
  run.particles.system.start_creeping();
}

/// Last pictures and fields, summary.json. Collective.
void write_results(CoupledRun& run, CoupledSink& sink, const Scene& scene, const Outcome& outcome) {
  const std::string& folder = sink.tables.folder;
  const Prepared& prepared = scene.prepared;
  write_end(run, sink, scene.canvas, scene.solid);
  if (config::find_output(scene.the_case, config::OutputKind::pictures) != nullptr) {
    draw_fields(folder, scene.the_case, prepared.sample, run.domain, cell_fields(run), scene.solid,
                run.solver.block(), sink.tables.provenance, run.comm());
  }
  Json summary = summarise(scene.the_case, prepared.sample, run.domain, scene.clean, scene.facts);
  add_coupled(summary, run);
  summary.set("status", outcome.ending.status);
  if (!outcome.ending.reason.empty()) {
    summary.set("reason", outcome.ending.reason);
  }
  on_root(run.comm(), [&] { write_file(folder + "/summary.json", summary.text()); });
}

}  // namespace

int run_coupled_case(const config::Case& the_case, const RunOptions& options,
                     const par::Communicator& comm, std::optional<Log>& log) {
  const Stopwatch watch;
  const io::Provenance provenance = io::make_provenance(comm.size(), the_case.run.random_seed);
  const Prepared prepared = prepare(the_case, comm);
  if (options.dry_run) {
    show_plan(the_case, options, prepared, provenance, comm);
    return exit_code::done;
  }
  const std::string& folder = options.output_dir;
  const Start start = options.restart ? Start::resumed : Start::fresh;
  log.emplace(open_folder(folder, the_case, comm, start));
  say(*log, comm, provenance, prepared.story);

  const Domain& domain = prepared.domain;
  flow::StokesSolver solver(comm, prepared.cut, domain.spacing, domain.boundaries,
                            the_case.fluid.viscosity);
  Scene scene = set_scene(the_case, prepared, solver, comm, watch, *log);
  scene.facts.provenance = provenance;
  const config::Case boxed = with_box_of_flow(the_case);
  CoupledRun run = make_coupled_run(boxed, prepared.sample, domain, prepared.cut, solver,
                                    scene.clean, scene.facts.porosity.connected, comm);
  begin(run, options, *log);
  CoupledSink sink =
      open_coupled_sink(folder, run, prepared.sample, scene.solid, provenance, start);
  const Outcome outcome =
      safely([&] { return simulate(run, sink, scene.canvas, scene.solid, watch, *log); });
  scene.facts.peak_memory = comm.sum(static_cast<Real>(peak_memory()));
  scene.facts.wall_time = watch.seconds();
  write_rest(outcome, folder, [&] {
    write_results(run, sink, scene, outcome);
    say_coupled(*log, run, outcome);
    say_fates(*log, run.state.readings.clogging);
    log->info("results    {}", folder);
  });
  return outcome.exit_code;
}

}  // namespace porefines::sim
