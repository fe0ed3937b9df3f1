// SPDX-License-Identifier: MPL-2.0
// Sentences of the coupled loop about the flow: its solve, the motions that come of it, the inlets.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"
#include "flow/rigid_projection.hpp"
#include "sim/coupled_inertia.hpp"
#include "sim/coupled_state.hpp"
#include "sim/particle_setup.hpp"

namespace porefines::sim {
namespace {

using std::numbers::pi;

/// The spheres of this rank as the flow sees them: weight less buoyancy, the case's force, and the
/// mean contact force of the last step, F* of algorithm.md section 5.
std::vector<flow::Sphere> spheres_of(CoupledRun& run) {
  dem::Particles& p = run.particles.system.particles();
  const Vec3 corner = run.domain.origin();
  std::vector<flow::Sphere> spheres;
  for (std::size_t i = 0; i < p.owned; ++i) {
    dem::Creeping& c = p.creeping;
    c.told_force[i] = c.mean_force[i];
    c.told_torque[i] = c.mean_torque[i];
    flow::Sphere q;
    q.id = p.id[i];
    q.position = p.position[i] - corner;
    q.radius = p.radius[i];
    q.held = p.is_fixed(i);
    q.velocity = q.held ? Vec3{} : c.free_velocity[i];
    q.spin = q.held ? Vec3{} : c.free_spin[i];
    q.force = outer_force(run.the_case, run.the_case.particles[p.species[i]], p.radius[i]) +
              c.mean_force[i];
    q.torque = c.mean_torque[i];
    spheres.push_back(q);
  }
  return spheres;
}

void take_motions(CoupledRun& run, const std::vector<flow::SphereMotion>& motions) {
  dem::Particles& p = run.particles.system.particles();
  const Real mu = run.the_case.fluid.viscosity;
  for (std::size_t i = 0; i < p.owned; ++i) {
    dem::Creeping& c = p.creeping;
    const Real a = p.radius[i];
    c.free_velocity[i] = motions[i].velocity;
    c.free_spin[i] = motions[i].spin;
    c.told_force[i] +=
        motions[i].contact;  // the solve held it so: it is the contact's to take over
    c.resistance[i] = 6 * pi * mu * a;
    c.spin_resistance[i] = 8 * pi * mu * a * a * a;
    if (c.drift_step[i] == 0) {  // newly come: it moves as the flow says until it has touched
      p.velocity[i] = motions[i].velocity;
      p.angular_velocity[i] = motions[i].spin;
    }
  }
}

flow::Drive scaled(const flow::Drive& drive, Real factor) {
  flow::Drive out = drive;
  out.force *= factor;
  for (Real& value : out.face_value) {
    value *= factor;
  }
  return out;
}

/// @throws RunError  it did not converge
template <typename Report>
void take_note(CoupledRun& run, const Report& report, Real wanted) {
  count_solve(run, report.cycles, report.residual);
  if (!report.converged) {
    throw RunError(
        fmt::format("the solve at {:.6g} s {}: residual {:.3g} after {} cycles, wanted {:.3g}\n"
                    "try a smaller grid.cell_size, or a larger flow.max_cycles",
                    run.time(), std::isfinite(report.residual) ? "did not converge" : "broke down",
                    report.residual, report.cycles, wanted));
  }
}

void solve_once(CoupledRun& run, const flow::Drive& drive) {
  flow::SolveOptions options;
  options.tolerance = run.cold ? run.the_case.flow.tolerance : run.the_case.coupling.tolerance;
  run.cold = false;
  options.max_cycles = run.the_case.flow.max_cycles;
  take_note(run, run.solver.solve(drive, options), options.tolerance);
}

/// A step of the fluid alone, then of rigid spheres. At the start, one in which the fluid moves as far as
/// particles may.
void project_once(CoupledRun& run, const flow::Drive& drive) {
  const flow::StepOptions options = step_options(run.the_case);
  const Real step =
      run.cold ? run.the_case.coupling.travel / std::max(run.inertial->crossing_rate(), 1e-30)
               : run.particles.state.step;
  run.cold = false;
  const auto motions = run.projection->advance(step, drive, spheres_of(run), options);
  take_note(run, run.projection->report(), options.tolerance);
  take_motions(run, motions);
}

}  // namespace

flow::StepOptions step_options(const config::Case& the_case) {
  flow::StepOptions options;
  options.tolerance = the_case.coupling.tolerance;
  options.max_cycles = the_case.flow.max_cycles;
  return options;
}

void count_solve(CoupledRun& run, int cycles, Real residual) {
  run.now.cycles += cycles;
  run.now.residual = residual;
  run.state.cycles += cycles;
  ++run.state.solves;
}

std::vector<flow::WallGap> walls_near(const CoupledRun& run) {
  const dem::System& system = run.particles.system;
  const dem::Particles& p = system.particles();
  const Real reach = flow::lubrication_range * run.domain.spacing.x;
  std::vector<flow::WallGap> walls;
  dem::TouchList touches;
  for (std::size_t i = 0; i < p.owned; ++i) {
    dem::find_touches(system.settings().walls, p.position[i], p.radius[i], reach, touches);
    for (const dem::Touch& touch : touches.view()) {
      walls.push_back({i, touch.normal, touch.gap, touch.share});
    }
  }
  return walls;
}

void feed_inlets(CoupledRun& run) {
  const Domain& domain = run.domain;
  for (std::size_t k = 0; k < run.particles.inlets.size(); ++k) {
    dem::Inlet& inlet = run.particles.inlets[k];
    const config::Injection& asked = run.the_case.injection[k];
    const int axis = axis_of(inlet.face);
    const int a = axis == 0 ? 1 : 0;
    const int b = axis == 2 ? 1 : 2;
    const bool given = domain.boundaries.at(axis, is_high(inlet.face)) == flow::FaceKind::velocity;
    const int plane = is_high(inlet.face) ? domain.cells[axis] - (given ? 1 : 0) : (given ? 1 : 0);
    const auto profile =
        std::make_shared<const std::vector<Real>>(run.solver.plane_velocities(axis, plane));
    const Vec3 corner = domain.origin();
    const Vec3 spacing = domain.spacing;
    const Int3 cells = domain.cells;
    inlet.flow = [=](const Vec3& x) {
      const auto cell = [&](int t) {
        const int i = static_cast<int>(std::floor((x[t] - corner[t]) / spacing[t]));
        return static_cast<std::size_t>(std::clamp(i, 0, cells[t] - 1));
      };
      Vec3 v;
      v[axis] = (*profile)[cell(b) * static_cast<std::size_t>(cells[a]) + cell(a)];
      return v;
    };
    const Real inwards = is_high(inlet.face) ? -1 : 1;
    Real rate = 0;
    inlet.fastest_flow = 0;
    for (int j = 0; j < cells[b]; ++j) {
      for (int i = 0; i < cells[a]; ++i) {
        const Real y = corner[a] + (i + 0.5) * spacing[a];
        const Real z = corner[b] + (j + 0.5) * spacing[b];
        if (y < inlet.low[a] || y > inlet.high[a] || z < inlet.low[b] || z > inlet.high[b]) {
          continue;
        }
        const Real v = inwards * (*profile)[static_cast<std::size_t>(j) * cells[a] + i];
        rate += std::max(v, 0.0) * spacing[a] * spacing[b];
        inlet.fastest_flow = std::max(inlet.fastest_flow, v);
      }
    }
    if (asked.kind != config::Concentration::rate) {
      inlet.rate = injected_volume(run.the_case, asked, inlet.density, rate);
    }
  }
}

Real CoupledRun::drive_at(Real moment) const {
  Real factor = 1;
  for (const config::DriveChange& change : the_case.drive) {
    factor = moment >= change.from ? change.factor : factor;
  }
  return factor;
}

namespace {

bool pump_keeps_rate(const CoupledRun& run) {
  constexpr Real accuracy = 1e-3;
  const Real wanted = run.wanted_rate * run.drive_now();
  return wanted == 0 || std::abs(run.now.darcy.flow_rate / wanted - 1) < accuracy;
}

/// Contact forces in the ratio of a drive that was turned: F* of a caught sphere, which balances the drag on
/// it, goes with the pressure. Were F* kept, the sphere would be told to give way to the difference, the rate
/// would answer as if nothing were caught, and a pump would swing. A touching sphere has
/// F* = -(F_drag + F_outer), and F_drag goes with the pressure. What a flow back takes along presses on nothing;
/// kept, F* would fade in hundreds of steps only.
void turn_contacts(CoupledRun& run, Real ratio) {
  dem::Particles& p = run.particles.system.particles();
  for (std::size_t i = 0; i < p.owned; ++i) {
    Vec3& force = p.creeping.mean_force[i];
    if (ratio < 0) {
      force = p.creeping.mean_torque[i] = Vec3{};
    } else if (dot(force, force) > 0) {
      const auto& species = run.the_case.particles[p.species[i]];
      force = ratio * force + (ratio - 1) * outer_force(run.the_case, species, p.radius[i]);
      p.creeping.mean_torque[i] *= ratio;
    }
  }
}

void turn_pump(CoupledRun& run) {
  // A pump that finds no way out still turns up step by step, not at once.
  const Real asked = run.wanted_rate * run.drive_now() / run.now.darcy.flow_rate;
  const Real ratio = asked > 0 ? std::min(asked, 2.0) : 2.0;
  run.state.drive_factor *= ratio;
  turn_contacts(run, ratio);
}

/// What [[drive]] changed since the last solve.
void follow_drive(CoupledRun& run) {
  const Real ratio = run.drive_now() / run.drive_at(run.time() - run.particles.state.step);
  if (!run.cold && ratio != 1) {
    turn_contacts(run, ratio);
    run.now.darcy.flow_rate *= ratio;  // what the pump has to expect
  }
}

}  // namespace

void solve_flow(CoupledRun& run) {
  run.now.cycles = 0;
  if (config::is_inertial(run.the_case)) {
    solve_with_inertia(run);
    return;
  }
  follow_drive(run);
  const int most_turns = run.projection ? 1 : 3;  // a step of the fluid is made once
  for (int turn = 0; turn < most_turns; ++turn) {
    if (!run.cold && !pump_keeps_rate(run)) {
      turn_pump(run);
    }
    const flow::Drive drive = scaled(run.drive, run.state.drive_factor * run.drive_now());
    if (run.projection) {
      project_once(run, drive);
    } else {
      run.solver.set_spheres(spheres_of(run), walls_near(run));
      solve_once(run, drive);
      take_motions(run, run.solver.sphere_motions());
    }
    run.now.darcy = measure_darcy(run.the_case, run.domain, drive, run.solver);
    if (pump_keeps_rate(run)) {
      break;
    }
  }
  feed_inlets(run);
}

}  // namespace porefines::sim
