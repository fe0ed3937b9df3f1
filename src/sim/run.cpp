// SPDX-License-Identifier: MPL-2.0
#include "sim/run.hpp"

#include <cmath>
#include <iostream>
#include <optional>

#include <fmt/format.h>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/log.hpp"
#include "core/memory.hpp"
#include "core/signals.hpp"
#include "sim/coupled_run.hpp"
#include "sim/dry_run.hpp"
#include "sim/inertial_run.hpp"
#include "sim/pictures.hpp"
#include "sim/prepare.hpp"
#include "sim/results.hpp"
#include "sim/session.hpp"
#include "sim/steady_flow.hpp"

namespace porefines::sim {
namespace {

void say_result(Log& log, const SteadyFlow& flow, Real re, const Porosity& porosity,
                const std::string& folder) {
  log.info("porosity   {:.4f}, connected {:.4f}", porosity.total, porosity.connected);
  log.info("flow       {:.4g} m^3/s under {:.4g} Pa over the sample", flow.flow_rate,
           flow.pressure_drop);
  log.info("k          {:.5g} m^2 = {:.5g} darcy", flow.permeability, flow.permeability / darcy);
  log.info("solve      {} cycles, residual {:.2g}, flux varies by {:.2g}", flow.solve.cycles,
           flow.solve.residual, flow.flux_variation);
  if (re > 1) {
    log.warn("Re = {:.3g} > 1: inertia matters, Darcy's law and this creeping flow do not hold",
             re);
  }
  log.info("results    {}", folder);
}

SteadyFlow solve(const config::Case& the_case, const Domain& domain, flow::StokesSolver& solver,
                 const std::string& folder, const par::Communicator& comm) {
  try {
    SteadyFlow solution = solve_steady_flow(the_case, domain, solver, comm);
    if (solution.signal != 0) {
      throw Interrupted{solution.signal};
    }
    return solution;
  } catch (const RunError& error) {
    write_failure(folder, error.what(), comm);
    throw;
  }
}

/// Fields and pictures. Collective.
void write_flow(const config::Case& the_case, const std::string& folder, const Prepared& prepared,
                const SteadyFlow& solution, flow::StokesSolver& solver,
                const std::vector<float>& solid, const io::Provenance& provenance,
                const par::Communicator& comm) {
  if (!config::find_output(the_case, config::OutputKind::fields) &&
      !config::find_output(the_case, config::OutputKind::pictures)) {
    return;
  }
  const flow::StokesSolver::CellFields fields =
      case_fields(solver, solution.scale, solution.offset);
  if (config::find_output(the_case, config::OutputKind::fields)) {
    io::FieldWriter writer = open_fields(folder, prepared.domain, solver.block(), provenance, comm);
    write_fields(writer, 0, fields, solid);
  }
  stop_if_asked(comm);
  if (config::find_output(the_case, config::OutputKind::pictures)) {
    draw_fields(folder, the_case, prepared.sample, prepared.domain, fields, solid, solver.block(),
                provenance, comm);
  }
}

void simulate(const config::Case& the_case, const RunOptions& options,
              const par::Communicator& comm, std::optional<Log>& log) {
  const Stopwatch watch;
  const io::Provenance provenance = io::make_provenance(comm.size(), the_case.run.random_seed);
  if (options.restart) {
    throw InputError("a steady run has no checkpoint to restart from: run it without --restart");
  }
  const Prepared prepared = prepare(the_case, comm);
  const Domain& domain = prepared.domain;
  if (options.dry_run) {
    show_plan(the_case, options, prepared, provenance, comm);
    return;
  }
  const std::string& folder = options.output_dir;
  log.emplace(open_folder(folder, the_case, comm));
  say(*log, comm, provenance, prepared.story);

  flow::StokesSolver solver(comm, prepared.cut, domain.spacing, domain.boundaries,
                            the_case.fluid.viscosity);
  const std::vector<float> solid = set_up(solver, the_case, prepared, comm);
  log->info("set-up     {:.2g} s", watch.seconds());
  const SteadyFlow solution = solve(the_case, domain, solver, folder, comm);
  write_flow(the_case, folder, prepared, solution, solver, solid, provenance, comm);

  RunFacts facts = facts_of(prepared, solver, solid, provenance, comm);
  take_cost(facts, watch, comm);
  stop_if_asked(comm);
  on_root(comm, [&] {
    write_file(folder + "/summary.json",
               summarise(the_case, prepared.sample, domain, solution, facts).text());
  });
  say_result(*log, solution, reynolds(the_case, solution, facts.porosity.connected, domain),
             facts.porosity, folder);
}

}  // namespace

int run(const config::Case& the_case, const RunOptions& options) {
  const par::Communicator comm;
  if (config::is_dry(the_case)) {
    return run_dry(the_case, options, comm);
  }
  std::optional<Log> log;
  try {
    if (config::is_coupled(the_case)) {
      return run_coupled_case(the_case, options, comm, log);
    }
    if (config::is_inertial(the_case)) {
      return run_inertial_case(the_case, options, comm, log);
    }
    simulate(the_case, options, comm, log);
    return exit_code::done;
  } catch (const Interrupted& stop) {
    if (!log) {
      log.emplace("", comm.is_root() ? &std::cout : nullptr);
    }
    log->warn("stopped by signal {}: no results were written", stop.signal);
    return exit_code::signal_base + stop.signal;
  }
}

}  // namespace porefines::sim
