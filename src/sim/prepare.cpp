// SPDX-License-Identifier: MPL-2.0
#include "sim/prepare.hpp"

#include <iostream>

#include "core/atomic_file.hpp"
#include "core/json.hpp"
#include "core/log.hpp"
#include "core/memory.hpp"
#include "sim/grains.hpp"
#include "sim/particle_plan.hpp"
#include "sim/pictures.hpp"
#include "sim/probe.hpp"
#include "sim/session.hpp"

namespace porefines::sim {

Prepared prepare(const config::Case& the_case, const par::Communicator& comm) {
  stop_if_asked(comm);
  geom::Sample sample = geom::build_sample(geometry_spec(the_case), comm.handle());
  stop_if_asked(comm);
  const Domain domain = make_domain(the_case, sample);
  const Probe probe = probe_grid(sample, domain);
  par::Decomposition cut =
      par::decompose(domain.cells, comm.size(), probe.work, the_case.grid.decomposition);
  Plan plan = make_plan(the_case, sample, domain, probe, cut);
  estimate_seconds(the_case, plan, comm);
  std::vector<std::string> fines;
  if (config::is_coupled(the_case)) {
    const ParticlePlan particles =
        plan_particles(the_case, domain, probe.porosity, plan.velocity, plan.cycle_seconds);
    plan.memory += particles.memory;
    plan.memory_most += particles.memory;
    plan.seconds += particles.seconds;
    fines = describe(particles, domain);
  }
  require_memory(the_case, plan, domain, comm);
  stop_if_asked(comm);
  std::vector<std::string> story = describe(the_case, sample, domain, probe, plan);
  story.insert(story.end(), fines.begin(), fines.end());
  return {std::move(sample), domain, plan, std::move(cut), std::move(story)};
}

void show_plan(const config::Case& the_case, const RunOptions& options, const Prepared& prepared,
               const io::Provenance& provenance, const par::Communicator& comm) {
  on_root(comm, [&] {
    make_folder(options.output_dir);
    Json plan;
    plan.set("cells", prepared.plan.cells);
    plan.set("memory_bytes", prepared.plan.memory);
    plan.set("memory_most_bytes", prepared.plan.memory_most);
    plan.set("seconds", prepared.plan.seconds);
    write_file(options.output_dir + "/plan.json", plan.text());
    draw_sample(options.output_dir, the_case, prepared.sample, prepared.domain, provenance);
    Log log("", &std::cout);
    for (const std::string& line : prepared.story) {
      log.info("{}", line);
    }
    log.info("picture    {}/geometry.png", options.output_dir);
  });
}

/// Links fluid and grains; returns the share of solid in every cell.
std::vector<float> set_up(flow::StokesSolver& solver, const config::Case& the_case,
                          const Prepared& prepared, const par::Communicator& comm) {
  const geom::Solid grains =
      local_solid(the_case, prepared.sample, prepared.domain, prepared.cut, comm.rank());
  stop_if_asked(comm);
  link_grains(solver, the_case, prepared.sample, grains, prepared.domain);
  stop_if_asked(comm);
  std::vector<float> solid =
      solid_fraction(the_case, prepared.sample, grains, prepared.domain, solver.block());
  stop_if_asked(comm);
  give_back_memory();
  return solid;
}

RunFacts facts_of(const Prepared& prepared, const flow::StokesSolver& solver,
                  const std::vector<float>& solid, const io::Provenance& provenance,
                  const par::Communicator& comm) {
  RunFacts facts;
  facts.porosity = measure_porosity(prepared.sample, prepared.domain, solver.block(), solid, comm);
  facts.fluid_cells = solver.fluid_cells();
  facts.plan = prepared.plan;
  facts.provenance = provenance;
  return facts;
}

void take_cost(RunFacts& facts, const Stopwatch& watch, const par::Communicator& comm) {
  facts.peak_memory = comm.sum(static_cast<Real>(peak_memory()));
  facts.traffic = par::share_traffic(par::traffic(), comm);
  facts.wall_time = watch.seconds();
}

flow::StokesSolver::CellFields case_fields(flow::StokesSolver& solver, Real scale, Real offset) {
  flow::StokesSolver::CellFields fields = solver.cell_fields();
  for (auto& component : fields.velocity) {
    for (float& value : component) {
      value *= static_cast<float>(scale);
    }
  }
  for (std::size_t at = 0; at < fields.pressure.size(); ++at) {
    const Real p = fields.pressure[at] * scale + offset;
    fields.pressure[at] = fields.fluid[at] != 0 ? static_cast<float>(p) : 0;
  }
  return fields;
}

}  // namespace porefines::sim
