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
#include "sim/inertial_setup.hpp"
#include "sim/pictures.hpp"
#include "sim/prepare.hpp"
#include "sim/results.hpp"
#include "sim/session.hpp"

namespace porefines::sim {
namespace {

Outcome simulate(CoupledRun& run, CoupledSink& sink, const RunCanvas& canvas,
                 std::span<const float> solid, const Stopwatch& watch, Log& log) {
  const DryState& now = run.particles.state;
  Keeper keeper(run.comm(), run.the_case, watch, log, now.time,
                [&] { write_checkpoint(run, sink.tables.folder, sink.tables.provenance); });
  if (run.cold) {
    solve_flow(run);
  }
  write_coupled(run, sink, "", canvas, solid);
  while (now.time < run.the_case.run.end_time && limit_reached(run).empty()) {
    const Real step = move_particles(run, choose_step(run));  // with the flow and each other
    stiffen_contacts(run);                                    // before overlaps reach their bound
    const std::string left = pass_openings(run, step);        // out, and in
    require_bearable(run);                                    // overlaps within their bound
    solve_flow(run);                                // fluid and rigid particles in one system
    write_coupled(run, sink, left, canvas, solid);  // of this moment
    if (const auto stop = keeper.after_step(now.time, now.steps)) {
      return *stop;
    }
  }
  keeper.save(now.time, now.steps);
  return {.ending = {.reason = limit_reached(run)}};
}

void say_coupled(Log& log, const CoupledRun& run, const Outcome& outcome) {
  say_particles(log, run.particles);
  if (is_driven(run.the_case.flow)) {
    log.info("k/k0       {:.4f} after {:.4g} pore volumes", run.permeability_ratio(),
             run.pore_volumes());
  }
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
                const io::Provenance& provenance, const par::Communicator& comm,
                const Stopwatch& watch, Log& log) {
  Scene scene{the_case, prepared, set_up(solver, the_case, prepared, comm), {}, {}, {}};
  log.info("set-up     {:.2g} s", watch.seconds());
  const Domain& domain = prepared.domain;
  if (is_driven(the_case.flow)) {
    scene.clean = solve_steady_flow(the_case, domain, solver, comm);
    if (scene.clean.signal != 0) {
      throw Interrupted{scene.clean.signal};
    }
    log.info("clean k    {:.5g} m^2 = {:.5g} darcy", scene.clean.permeability,
             scene.clean.permeability / darcy);
  } else {
    solver.rest();  // particles, or a lid, will move it
  }
  const SteadyFlow& clean = scene.clean;
  const flow::StokesSolver::CellFields fields = case_fields(solver, clean.scale, clean.offset);
  scene.canvas = make_canvas(domain, prepared.sample, fields, scene.solid, solver.block(), comm);
  scene.facts = facts_of(prepared, solver, scene.solid, provenance, comm);
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
  const geom::Sample& sample = scene.prepared.sample;
  write_end(run, sink, scene.canvas, sample, scene.solid);
  Json summary = summarise(scene.the_case, sample, run.domain, scene.clean, scene.facts);
  add_coupled(summary, run);
  write_summary(sink.tables.folder, std::move(summary), outcome.ending, run.comm());
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
  solver.set_roughness(the_case.coupling.roughness);
  const config::Case told = config::is_inertial(the_case) ? with_velocities(the_case, domain)
                                                          : with_rates(the_case, domain);
  Scene scene = set_scene(told, prepared, solver, provenance, comm, watch, *log);
  const config::Case boxed = with_box_of_flow(told);
  CoupledRun run = make_coupled_run(boxed, prepared.sample, domain, prepared.cut, solver,
                                    scene.clean, scene.facts.porosity.connected, comm);
  begin(run, options, *log);
  CoupledSink sink =
      open_coupled_sink(folder, run, prepared.sample, scene.solid, provenance, start);
  const Outcome outcome =
      safely(folder, [&] { return simulate(run, sink, scene.canvas, scene.solid, watch, *log); });
  take_cost(scene.facts, watch, comm);
  write_rest(outcome, [&] {
    write_results(run, sink, scene, outcome);
    say_coupled(*log, run, outcome);
    say_fates(*log, run.state.readings.clogging);
    log->info("results    {}", folder);
  });
  return outcome.exit_code;
}

}  // namespace porefines::sim
