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
#include "sim/grains.hpp"
#include "sim/pictures.hpp"
#include "sim/prepare.hpp"
#include "sim/results.hpp"
#include "sim/session.hpp"

namespace porefines::sim {
namespace {

/// How a coupled run ended.
struct CoupledEnd {
  std::string status = "done";
  std::string reason;
  int exit_code = exit_code::done;
  std::string error;  ///< to throw when everything is written
};

/// Anything from outside that ends the loop.
std::optional<CoupledEnd> interruption(const CoupledRun& run, const Stopwatch& watch) {
  if (const int signal = signal_anywhere(run.comm()); signal != 0) {
    return CoupledEnd{"interrupted", fmt::format("signal {}", signal),
                      exit_code::signal_base + signal, ""};
  }
  const Real limit = run.the_case.run.max_wall;
  if (limit > 0 && run.comm().max(watch.seconds()) > limit) {
    return CoupledEnd{
        "stopped", "max_wall", exit_code::stopped_itself,
        fmt::format("run.max_wall is over at {:.6g} s of {:.6g} s; results are those so "
                    "far, and --restart goes on",
                    run.time(), run.the_case.run.end_time)};
  }
  return {};
}

/// Writes a checkpoint; a failure is a warning, since the run has its worth without. Collective.
void save(const CoupledRun& run, CoupledSink& sink, const Stopwatch& watch, Log& log) {
  sink.saved = run.comm().max(watch.seconds());
  try {
    write_checkpoint(run, sink.folder, sink.provenance);
    log.info("checkpoint at {:.9g} s, step {}", run.time(), run.particles.state.steps);
  } catch (const RunError& failure) {
    log.warn("no checkpoint at {:.6g} s: {}", run.time(), failure.what());
  }
}

CoupledEnd simulate(CoupledRun& run, CoupledSink& sink, std::span<const float> solid,
                    const Stopwatch& watch, Log& log) {
  std::optional<Progress> progress;
  if (run.comm().is_root()) {
    progress.emplace("run");
  }
  const Real end = run.the_case.run.end_time;
  std::string left;
  while (true) {
    solve_flow(run);                        // fluid and rigid particles in one system
    write_coupled(run, sink, left, solid);  // of this moment
    look_at_limits(run);
    if (run.time() >= end || run.state.stopped) {
      save(run, sink, watch, log);
      return {"done", run.state.reason, exit_code::done, ""};
    }
    const Real step = choose_step(run);
    move_particles(run, step);        // with the flow and against each other
    left = pass_openings(run, step);  // out, and in
    require_healthy(run.particles);   // overlaps within their bound
    if (progress) {
      progress->update(run.time() / end);
    }
    if (const auto stop = interruption(run, watch)) {
      save(run, sink, watch, log);
      return *stop;
    }
    if (run.comm().max(watch.seconds()) - sink.saved >= run.the_case.checkpoint.every) {
      save(run, sink, watch, log);
    }
  }
}

/// The same, with errors as an ending: what there is will be written before they are reported.
CoupledEnd simulate_safely(CoupledRun& run, CoupledSink& sink, std::span<const float> solid,
                           const Stopwatch& watch, Log& log) {
  std::string error;
  try {
    return simulate(run, sink, solid, watch, log);
  } catch (const RunError& failure) {
    error = failure.what();
  }
  return {"stopped", error, exit_code::stopped_itself, error};
}

void say_coupled(Log& log, const CoupledRun& run, const CoupledEnd& end) {
  const Ledger& ledger = run.particles.state.ledger;
  log.info("particles  {} placed + {} injected = {} inside + {} out", ledger.placed,
           ledger.injected, ledger.expected_inside(), ledger.out);
  for (std::size_t k = 0; k < run.particles.inlets.size(); ++k) {
    if (run.particles.state.inlets[k].waiting > 0) {
      log.warn("{}: {} particles were due but found no room at the inlet",
               run.the_case.injection[k].species, run.particles.state.inlets[k].waiting);
    }
  }
  log.info("k/k0       {:.4f} after {:.4g} pore volumes", run.permeability_ratio(),
           run.pore_volumes());
  log.info("steps      {} to {:.4g} s, {:.3g} cycles per solve, {} contact substeps",
           run.particles.state.steps, run.time(),
           static_cast<Real>(run.state.cycles) / static_cast<Real>(run.state.solves),
           run.state.substeps);
  if (!end.reason.empty()) {
    log.info("ended      {}", end.reason);
  }
}

/// Pictures of the last moment. Collective.
void draw_end(CoupledRun& run, const std::string& folder, const geom::Sample& sample,
              std::span<const float> solid, const io::Provenance& provenance) {
  if (config::find_output(run.the_case, config::OutputKind::pictures) == nullptr) {
    return;
  }
  draw_dry(folder + "/particles.png", run.particles, provenance);
  flow::StokesSolver::CellFields fields = run.solver.cell_fields();
  to_case_units(fields, 1, run.offset);
  draw_fields(folder, run.the_case, sample, run.domain, fields, solid, run.solver.block(),
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

  CoupledRun run = make_coupled_run(the_case, prepared.sample, domain, prepared.cut, solver, clean,
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
  const CoupledEnd end = simulate_safely(run, sink, solid, watch, *log);
  draw_end(run, folder, prepared.sample, solid, provenance);
  facts.peak_memory = comm.sum(static_cast<Real>(peak_memory()));
  facts.wall_time = watch.seconds();
  Json summary = summarise(the_case, prepared.sample, domain, clean, facts);
  add_coupled(summary, run);
  summary.set("status", end.status);
  if (!end.reason.empty()) {
    summary.set("reason", end.reason);
  }
  on_root(comm, [&] { write_file(folder + "/summary.json", summary.text()); });
  say_coupled(*log, run, end);
  log->info("results    {}", folder);
  if (!end.error.empty()) {
    throw RunError(end.error);
  }
  return end.exit_code;
}

}  // namespace porefines::sim
