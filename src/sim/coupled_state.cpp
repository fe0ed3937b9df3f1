// SPDX-License-Identifier: MPL-2.0
#include "sim/coupled_state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"
#include "dem/packing.hpp"
#include "dem/step_size.hpp"
#include "sim/beds.hpp"
#include "sim/coupled_inertia.hpp"
#include "sim/particle_setup.hpp"
#include "sim/particle_walls.hpp"
#include "sim/prepare.hpp"

namespace porefines::sim {
namespace {

/// Openings and their pressures: a rate is reached by scaling the drop of the clean flow.
void set_drive(CoupledRun& run, const SteadyFlow& clean) {
  const config::Flow& flow = run.the_case.flow;
  if (!flow.inlet) {
    run.drive.force = {flow.pressure_gradient[0], flow.pressure_gradient[1],
                       flow.pressure_gradient[2]};
    return;
  }
  const OpeningDrive wanted = opening_drive(flow);
  run.drive = wanted.drive;
  run.offset = clean.offset;
  run.wanted_rate = wanted.wanted_rate;
  run.state.drive_factor = clean.scale;
}

/// Young's moduli are lowered until the pressure drop on one particle, the most that the fluid can
/// press a lone one onto a throat with, overlaps it by half of what the case allows. Nothing but
/// overlaps depends on stiffness where particles creep; substeps grow with it.
void soften(CoupledRun& run) {
  const Real radius = largest_radius(run.the_case);
  const Vec3 size = run.domain.size();
  const Vec3& force = run.drive.force;
  const Real drop =
      std::max(run.state.drive_factor * (run.drive.face_value[2 * run.domain.axis] -
                                         run.drive.face_value[2 * run.domain.axis + 1]),
               0.0) +
      std::abs(force.x) * size.x + std::abs(force.y) * size.y + std::abs(force.z) * size.z;
  const Real viscous = run.the_case.fluid.viscosity * std::abs(run.state.clean_rate) *
                       run.domain.size()[run.domain.axis] /
                       (run.state.clean_permeability * run.domain.area());
  Real most = 1;
  for (const config::DriveChange& change : run.the_case.drive) {
    most = std::max(most, std::abs(change.factor));
  }
  const Real push = most * std::max(std::abs(drop), viscous) * std::numbers::pi * radius * radius;
  Real factor = 1;
  const dem::MaterialTable& table = run.particles.system.settings().materials;
  for (std::size_t a = 0; a < run.the_case.particles.size(); ++a) {
    factor = std::min(factor,
                      dem::softening_for_force(table.pair(static_cast<int>(a), static_cast<int>(a)),
                                               radius, push, run.the_case.contact.max_overlap / 4));
  }
  run.particles.system.soften(factor);
  run.state.stiffness = factor;
}

/// The explicit coupling: its fluid begins with the flow without particles.
void start_projection(CoupledRun& run, const par::Communicator& comm) {
  const Real density = run.the_case.fluid.density;
  const Real flows = std::abs(run.state.clean_rate) / run.domain.area();
  run.inertial = std::make_unique<flow::InertialFlow>(
      run.solver, density, flow::Scheme::none, flow::TimeScheme::euler,
      std::max(flows, particle_speed(run.the_case)), flow::InertialFlow::First::solved);
  run.projection =
      std::make_unique<flow::RigidProjection>(run.solver, *run.inertial, density, comm);
}

}  // namespace

config::Case with_rates(config::Case the_case, const Domain& domain) {
  const bool pumps = config::pumps_velocities(the_case);
  for (auto* opening : {&the_case.flow.inlet, &the_case.flow.outlet}) {
    if (pumps && *opening && (*opening)->kind == config::DriveKind::velocity) {
      (*opening)->kind = config::DriveKind::flow_rate;
      (*opening)->value *= domain.area();
    }
  }
  return the_case;
}

config::Case with_box_of_flow(config::Case the_case) {
  const config::Flow& flow = the_case.flow;
  the_case.box.periodic = flow.periodic;
  the_case.box.smooth = flow.slip;
  for (const auto& opening : {flow.inlet, flow.outlet}) {
    if (opening) {
      the_case.box.open[static_cast<std::size_t>(opening->face)] = true;
    }
  }
  return the_case;
}

MomentFields fields_of_moment(CoupledRun& run) {
  const auto kept = std::make_shared<std::optional<flow::StokesSolver::CellFields>>();
  return [&run, kept]() -> const flow::StokesSolver::CellFields& {
    if (!*kept) {
      *kept = case_fields(run.solver, 1, run.offset);
    }
    return **kept;
  };
}

CoupledRun make_coupled_run(const config::Case& the_case, const geom::Sample& sample,
                            const Domain& domain, const par::Decomposition& cut,
                            flow::StokesSolver& solver, const SteadyFlow& clean, Real porosity,
                            const par::Communicator& comm) {
  const Vec3 low = domain.origin();
  dem::Settings settings =
      make_settings(the_case, sample, {low, low + domain.size(), the_case.box.periodic});
  settings.blocks = dem::make_blocks(cut, settings.box);
  CoupledRun run{
      the_case,
      domain,
      solver,
      DryRun{the_case, comm, dem::System(comm, settings), make_inlets(the_case, settings.box), {}},
      {},
      0,
      0,
      porosity * domain.area() * domain.length(),
      {},
      {},
      true,
      {},
      {}};
  run.particles.in_fluid = true;
  run.particles.state.inlets.resize(run.particles.inlets.size());
  run.state.clean_permeability = clean.permeability;
  run.state.clean_rate = clean.flow_rate;
  if (config::is_inertial(the_case)) {
    start_inertia(run);
    return run;
  }
  set_drive(run, clean);
  soften(run);
  if (the_case.coupling.method == config::CouplingMethod::projected) {
    start_projection(run, comm);
  }
  return run;
}

}  // namespace porefines::sim
