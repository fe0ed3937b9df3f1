// SPDX-License-Identifier: MPL-2.0
#include "sim/dry_state.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <mpi.h>

#include "analysis/moments.hpp"
#include "core/error.hpp"
#include "sim/particle_setup.hpp"

namespace porefines::sim {
namespace {

void require_open(const DryRun& run) {
  for (std::size_t k = 0; k < run.inlets.size(); ++k) {
    if (dem::open_share(run.system, run.comm, run.inlets[k]) == 0) {
      throw InputError(
          fmt::format("[injection] {}: every place in the window is inside rock or a wall\n"
                      "choose another face or region, or smaller particles",
                      run.the_case.injection[k].species));
    }
  }
}

}  // namespace

bool has_energy_balance(const config::Case& the_case) {
  const auto still = [](const config::Shape& shape) { return shape.velocity == config::Triple{}; };
  bool balanced = std::all_of(the_case.surface.begin(), the_case.surface.end(), still);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bool pushed = the_case.gravity[axis] != 0;
    for (const config::Particles& p : the_case.particles) {
      pushed = pushed || p.force[axis] != 0;
    }
    balanced = balanced && !(pushed && the_case.box.periodic[axis]);
  }
  return balanced;
}

DryRun make_dry_run(const config::Case& the_case, const geom::Sample& sample,
                    const par::Communicator& comm) {
  const dem::Settings settings = make_settings(the_case, sample);
  DryRun run{the_case, comm, dem::System(comm, settings), make_inlets(the_case, settings.box), {}};
  run.state.inlets.resize(run.inlets.size());
  return run;
}

std::vector<std::string> place_particles(DryRun& run) {
  const Bed bed = make_bed(run.the_case, run.system.settings());
  run.system.insert(bed.bodies);
  set_forces(run);
  require_apart(run.system, run.the_case.contact.max_overlap, run.comm);
  require_open(run);
  run.state.next_id = bed.bodies.size();
  run.state.ledger.placed = static_cast<Index>(bed.bodies.size());
  run.state.energy.start = look(run).energy;
  return bed.remarks;
}

Moment look(const DryRun& run) {
  const dem::Particles& p = run.system.particles();
  analysis::MomentSums sums;
  Real potential = 0;
  for (std::size_t i = 0; i < p.owned; ++i) {
    sums.add(p.position[i], p.velocity[i]);
    potential -= dot(p.external_force[i], p.position[i]);
  }
  run.comm.sum(sums.values);
  potential = run.comm.sum(potential);
  Moment now;
  now.totals = run.system.totals();
  const auto count = std::max<Real>(static_cast<Real>(now.totals.particles), 1);
  const analysis::Moments moments = analysis::moments_of(sums);
  now.mean_speed = moments.mean_speed;
  now.mean = moments.mean;
  now.sigma = moments.sigma;
  now.coordination = 2 * static_cast<Real>(now.totals.contacts) / count;
  now.max_overlap = run.system.largest_overlap();
  now.energy = has_energy_balance(run.the_case)
                   ? now.totals.kinetic + now.totals.rotational + now.totals.elastic +
                         now.totals.potential + potential
                   : std::nan("");
  const dem::Spent& spent = now.totals.dissipated;
  now.dissipated = spent.normal + spent.sliding + spent.rolling;
  const EnergyBook& book = run.state.energy;
  now.energy_lost = book.start + book.injected - book.out - now.energy;
  return now;
}

}  // namespace porefines::sim
