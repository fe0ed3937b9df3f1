// SPDX-License-Identifier: MPL-2.0
#include "sim/run.hpp"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>

#include <fmt/format.h>

#include "config/writer.hpp"
#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/log.hpp"
#include "core/memory.hpp"
#include "core/progress.hpp"
#include "core/signals.hpp"
#include "io/agree.hpp"
#include "sim/domain.hpp"
#include "sim/grains.hpp"
#include "sim/pictures.hpp"
#include "sim/plan.hpp"
#include "sim/probe.hpp"
#include "sim/results.hpp"
#include "sim/steady_flow.hpp"

namespace porefines::sim {
namespace {

class Stopwatch {
 public:
  [[nodiscard]] Real seconds() const {
    return std::chrono::duration<Real>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Does something on rank 0; its failure is everybody's.
template <typename Work>
void on_root(const par::Communicator& comm, const Work& work) {
  std::string failure;
  if (comm.is_root()) {
    try {
      work();
    } catch (const std::exception& error) {
      failure = error.what();
    }
  }
  io::throw_everywhere(comm.handle(), failure);
}

/// The output folder on rank 0, without the results of an earlier run: a run that stops must not
/// leave numbers that look like its own.
Log open_folder(const std::string& folder, const config::Case& the_case,
                const par::Communicator& comm) {
  on_root(comm, [&] {
    make_folder(folder);
    for (const std::string stale : {"summary.json", "speed.png", "pressure.png"}) {
      std::filesystem::remove(folder + "/" + stale);
    }
    write_file(folder + "/case.toml", config::effective_case(the_case));
  });
  std::optional<Log> log;
  on_root(comm, [&] { log.emplace(folder + "/log.txt", &std::cout); });
  return log ? std::move(*log) : Log("", nullptr);
}

void say(Log& log, const par::Communicator& comm, const io::Provenance& provenance,
         const std::vector<std::string>& plan) {
  if (comm.is_root()) {
    log.info("{}", io::describe(provenance));
    for (const std::string& line : plan) {
      log.info("{}", line);
    }
  }
}

/// The signal that any rank saw, or 0. Collective.
int signal_anywhere(const par::Communicator& comm) {
  return static_cast<int>(comm.max(static_cast<Real>(caught_signal())));
}

int leave(int signal, Log& log) {
  log.warn("stopped by signal {}: no results were written", signal);
  return exit_code::signal_base + signal;
}

int show_plan(const config::Case& the_case, const RunOptions& options, const geom::Sample& sample,
              const Domain& domain, const std::vector<std::string>& plan,
              const io::Provenance& provenance, const par::Communicator& comm) {
  on_root(comm, [&] {
    make_folder(options.output_dir);
    draw_sample(options.output_dir, the_case, sample, domain, provenance);
    Log log("", &std::cout);
    for (const std::string& line : plan) {
      log.info("{}", line);
    }
    log.info("picture    {}/geometry.png", options.output_dir);
  });
  return exit_code::done;
}

void write_failure(const std::string& folder, const std::string& reason,
                   const par::Communicator& comm) {
  on_root(comm, [&] {
    Json json;
    json.set("status", "stopped");
    json.set("reason", reason);
    write_file(folder + "/summary.json", json.text());
  });
}

void to_case_units(flow::StokesSolver::CellFields& fields, const SteadyFlow& flow) {
  for (auto& component : fields.velocity) {
    for (float& value : component) {
      value *= static_cast<float>(flow.scale);
    }
  }
  for (std::size_t at = 0; at < fields.pressure.size(); ++at) {
    const Real p = fields.pressure[at] * flow.scale + flow.offset;
    fields.pressure[at] = fields.fluid[at] != 0 ? static_cast<float>(p) : 0;
  }
}

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

}  // namespace

int run(const config::Case& the_case, const RunOptions& options) {
  watch_signals();
  const Stopwatch watch;
  const par::Communicator comm;
  const io::Provenance provenance = io::make_provenance(comm.size(), the_case.run.random_seed);
  if (options.restart) {
    throw InputError("a steady run has no checkpoint to restart from: run it without --restart");
  }

  const geom::Sample sample = geom::build_sample(geometry_spec(the_case), comm.handle());
  const Domain domain = make_domain(the_case, sample);
  const Probe probe = probe_grid(sample, domain);
  Plan plan = make_plan(the_case, sample, domain, probe, comm.size());
  require_memory(the_case, plan, domain, comm);
  const par::Decomposition cut =
      par::decompose(domain.cells, comm.size(), probe.work, the_case.grid.decomposition);
  plan.seconds = estimate_seconds(the_case, plan, comm);
  const std::vector<std::string> story = describe(the_case, sample, domain, probe, plan);
  if (options.dry_run) {
    return show_plan(the_case, options, sample, domain, story, provenance, comm);
  }

  const std::string& folder = options.output_dir;
  Log log = open_folder(folder, the_case, comm);
  say(log, comm, provenance, story);

  std::optional<geom::Solid> grains = local_solid(the_case, sample, domain, cut, comm.rank());
  flow::StokesSolver solver(comm, cut, domain.spacing, domain.boundaries, the_case.fluid.viscosity);
  link_grains(solver, the_case, sample, *grains, domain);
  const std::vector<float> solid =
      solid_fraction(the_case, sample, *grains, domain, solver.block());
  grains.reset();
  if (const int signal = signal_anywhere(comm); signal != 0) {
    return leave(signal, log);
  }

  SteadyFlow solution;
  try {
    solution = solve_steady_flow(the_case, domain, solver, comm);
  } catch (const RunError& error) {
    write_failure(folder, error.what(), comm);
    throw;
  }
  if (solution.signal != 0) {
    return leave(solution.signal, log);
  }

  flow::StokesSolver::CellFields fields = solver.cell_fields();
  to_case_units(fields, solution);
  if (the_case.output.fields) {
    write_fields(folder, domain, fields, solid, solver.block(), provenance, comm);
  }
  if (the_case.output.pictures) {
    draw_fields(folder, the_case, sample, domain, fields, solid, solver.block(), provenance, comm);
  }
  RunFacts facts;
  facts.porosity = measure_porosity(sample, domain, solver.block(), solid, comm);
  facts.fluid_cells = solver.fluid_cells();
  facts.peak_memory = comm.sum(static_cast<Real>(peak_memory()));
  facts.planned_memory = plan.memory;
  facts.wall_time = watch.seconds();
  facts.provenance = provenance;
  on_root(comm, [&] {
    write_file(folder + "/summary.json",
               summarise(the_case, sample, domain, solution, facts).text());
  });
  say_result(log, solution, reynolds(the_case, solution, facts.porosity.connected, domain),
             facts.porosity, folder);
  return exit_code::done;
}

}  // namespace porefines::sim
