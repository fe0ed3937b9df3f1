// SPDX-License-Identifier: MPL-2.0
#include "sim/coupled_inertia.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"
#include "dem/packing.hpp"
#include "dem/step_size.hpp"
#include "sim/inertial_setup.hpp"
#include "sim/particle_setup.hpp"
#include "sim/particle_walls.hpp"

namespace porefines::sim {
namespace {

/// Moduli such that an impact at this speed overlaps by half of what the case allows.
void soften(CoupledRun& run, Real speed) {
  const Real radius = largest_radius(run.the_case);
  const dem::Settings& settings = run.particles.system.settings();
  Real factor = 1;
  for (std::size_t a = 0; a < run.the_case.particles.size() && speed > 0; ++a) {
    const Real mass =
        (run.the_case.particles[a].density + settings.added_density) * dem::sphere_volume(radius);
    const auto one = static_cast<int>(a);
    factor =
        std::min(factor, dem::softening_for_speed(settings.materials.pair(one, one), radius, mass,
                                                  speed, run.the_case.contact.max_overlap / 4));
  }
  run.particles.system.soften(factor);
  run.state.stiffness = factor;
}

/// New particles have moved before as they do now.
void take_note_of_new(dem::Particles& p) {
  dem::Creeping& c = p.creeping;
  for (std::size_t i = 0; i < p.owned; ++i) {
    if (c.drift_step[i] == 0) {
      c.drift[i] = c.free_velocity[i] = p.velocity[i];
      c.drift_spin[i] = c.free_spin[i] = p.angular_velocity[i];
    }
  }
}

/// Forces that make the acceleration of the last step go on, contacts left out; of who is new: outer
/// forces alone.
void expect_forces(const CoupledRun& run, dem::Particles& p) {
  dem::Creeping& c = p.creeping;
  for (std::size_t i = 0; i < p.owned; ++i) {
    const bool new_here = c.drift_step[i] == 0;
    const Real mass = p.mass[i];
    c.told_force[i] = outer_force(run.the_case, run.the_case.particles[p.species[i]], p.radius[i]);
    c.told_torque[i] = {};
    if (!new_here) {
      c.told_force[i] = mass / c.drift_step[i] * (p.velocity[i] - c.drift[i]) - c.mean_force[i];
      c.told_torque[i] =
          p.inertia(i) / c.drift_step[i] * (p.angular_velocity[i] - c.drift_spin[i]) -
          c.mean_torque[i];
    }
    p.external_force[i] = c.told_force[i];
    p.external_torque[i] = c.told_torque[i];
    c.free_velocity[i] = p.velocity[i];
    c.free_spin[i] = p.angular_velocity[i];
  }
}

/// What contacts gave on the way, all that the expected forces did not; `way` keeps the impulse before.
void take_contact_forces(dem::Particles& p, Real step) {
  dem::Creeping& c = p.creeping;
  for (std::size_t i = 0; i < p.owned; ++i) {
    const bool fixed = p.is_fixed(i);
    c.way[i] = c.drift_step[i] * c.mean_force[i];
    c.way_spin[i] = c.drift_step[i] * c.mean_torque[i];
    c.mean_force[i] =
        fixed ? Vec3{} : p.mass[i] / step * (p.velocity[i] - c.free_velocity[i]) - c.told_force[i];
    c.mean_torque[i] =
        fixed ? Vec3{}
              : p.inertia(i) / step * (p.angular_velocity[i] - c.free_spin[i]) - c.told_torque[i];
  }
}

std::vector<flow::Sphere> heavy_spheres(const CoupledRun& run, Real step) {
  const auto [a0, a1, a2] = run.inertial->time_weights(step);
  const dem::Particles& p = run.particles.system.particles();
  const dem::Creeping& c = p.creeping;
  std::vector<flow::Sphere> spheres;
  for (std::size_t i = 0; i < p.owned; ++i) {
    const config::Particles& species = run.the_case.particles[p.species[i]];
    flow::Sphere q;
    q.id = p.id[i];
    q.position = p.position[i] - run.domain.origin();
    q.radius = p.radius[i];
    q.held = p.is_fixed(i);
    q.velocity = c.free_velocity[i];
    q.spin = c.free_spin[i];
    q.velocity_before = c.drift[i];
    q.spin_before = c.drift_spin[i];
    q.density = species.density;
    q.force = outer_force(run.the_case, species, p.radius[i]) + a0 * c.mean_force[i] +
              (a0 + a1) / step * c.way[i];
    q.torque = a0 * c.mean_torque[i] + (a0 + a1) / step * c.way_spin[i];
    spheres.push_back(q);
  }
  return spheres;
}

void take_motions(CoupledRun& run, Real step) {
  dem::Particles& p = run.particles.system.particles();
  dem::Creeping& c = p.creeping;
  const std::vector<flow::SphereMotion>& found = run.inertial->sphere_motions();
  for (std::size_t i = 0; i < p.owned; ++i) {
    c.drift[i] = c.free_velocity[i];
    c.drift_spin[i] = c.free_spin[i];
    c.drift_step[i] = step;
    p.velocity[i] = c.free_velocity[i] = found[i].velocity;
    p.angular_velocity[i] = c.free_spin[i] = found[i].spin;
  }
}

void advance_flow(CoupledRun& run, Real step) {
  const flow::StepOptions options = step_options(run.the_case);
  const flow::StepReport report = run.inertial->advance(step, run.drive, options);
  count_solve(run, report.cycles, report.residual);
  if (!report.converged) {
    throw RunError(fmt::format(
        "the flow did not converge at {:.6g} s: residual {:.3g} after {} cycles, wanted {:.3g}\n"
        "try a smaller flow.courant or coupling.travel, or a smaller grid.cell_size",
        run.time(), report.residual, report.cycles, options.tolerance));
  }
}

}  // namespace

Real particle_speed(const config::Case& the_case) {
  const Real radius = largest_radius(the_case);
  Real speed = 0;
  for (const config::Particles& species : the_case.particles) {
    const Real pull = norm(outer_force(the_case, species, radius));
    const Real viscous = pull / (6 * std::numbers::pi * the_case.fluid.viscosity * radius);
    const Real area = std::numbers::pi * radius * radius;
    const Real inertial = std::sqrt(pull / (0.2 * the_case.fluid.density * area));
    speed = std::max({speed, norm(vec(species.velocity)), std::min(viscous, inertial)});
  }
  return speed;
}

void start_inertia(CoupledRun& run) {
  const config::Case& the_case = run.the_case;
  const InertialDrive wanted = inertial_drive(the_case);
  run.drive = wanted.drive;
  run.offset = wanted.offset;
  const Push push = push_of(run.domain, run.drive);
  const Real flows =
      push.speed > 0 || push.force > 0 ? expected_speed(the_case, run.domain, push) : 0;
  const Real falls = particle_speed(the_case);
  // What only the spheres of a list bring along is not known here: a cell's Reynolds number of 1 is a unit as well.
  const Real unit = the_case.fluid.viscosity / (the_case.fluid.density * run.domain.spacing.x);
  const Real expected = std::max(flows, falls);
  run.inertial =
      make_inertial_flow(the_case, run.domain, run.solver, expected > 0 ? expected : unit,
                         flow::InertialFlow::First::solved);
  soften(run, std::max(falls, run.inertial->crossing_rate() * run.domain.spacing.x));
}

Real choose_inertial_step(const CoupledRun& run) {
  constexpr Real growth = 1.2;
  constexpr Real share = 0.5;  // of a gap that may close in a step
  const config::Inertia& asked = run.the_case.inertia;
  const Vec3& h = run.domain.spacing;
  const Real way = run.the_case.coupling.travel * std::min({h.x, h.y, h.z});
  const dem::Particles& p = run.particles.system.particles();
  Real rate = 0;  // of steps
  for (std::size_t i = 0; i < p.owned; ++i) {
    const dem::Creeping& c = p.creeping;
    const Real speed = norm(p.velocity[i]);
    Real gain =
        c.drift_step[i] > 0
            ? norm(p.velocity[i] - c.drift[i]) / c.drift_step[i]
            : norm(outer_force(run.the_case, run.the_case.particles[p.species[i]], p.radius[i])) /
                  p.mass[i];
    // v t + gain t^2/2 = way
    rate = std::max(rate, (speed + std::sqrt(speed * speed + 2 * gain * way)) / (2 * way));
  }
  rate = run.comm().max(rate);
  rate = std::max(rate, run.inertial->crossing_rate() / asked.courant);
  rate = std::max(rate, run.inertial->closing_rate() / share);
  const Real last = run.particles.state.step;
  const Real left = next_sample(run.particles) - run.time();
  Real longest = rate * left > 1 ? 1 / rate : left;
  longest = last > 0 ? std::min(longest, growth * last) : longest;
  longest = asked.time_step > 0 ? std::min(longest, asked.time_step) : longest;
  return left / std::max(std::ceil(left / longest - 1e-9), 1.0);
}

void move_with_inertia(CoupledRun& run, Real step) {
  DryRun& particles = run.particles;
  dem::Particles& p = particles.system.particles();
  take_note_of_new(p);
  expect_forces(run, p);
  if (run.comm().sum(static_cast<Index>(p.owned)) > 0) {
    const auto substeps =
        static_cast<Index>(std::ceil(std::max(step / longest_step(particles), 1.0)));
    particles.system.advance(step / static_cast<Real>(substeps), substeps);
    run.state.substeps += substeps;
  }
  take_contact_forces(p, step);
  advance_clock(particles.state, {step, 1}, next_sample(particles));
  run.state.fluid_passed += std::abs(run.now.darcy.flow_rate) * step;
}

void recall_inertia(CoupledRun& run, const flow::InertialFlow::Memory& memory) {
  run.inertial->recall(memory,
                       run.projection ? std::vector<flow::Sphere>{} : heavy_spheres(run, 1));
  run.cold = false;
  feed_inlets(run);
}

void solve_with_inertia(CoupledRun& run) {
  take_note_of_new(run.particles.system.particles());
  if (run.cold) {
    run.cold = false;
  } else {
    const Real step = run.particles.state.step;
    run.inertial->set_spheres(heavy_spheres(run, step), walls_near(run));
    advance_flow(run, step);
    take_motions(run, step);
  }
  run.now.darcy = measure_darcy(run.the_case, run.domain, run.drive, run.solver);
  feed_inlets(run);
}

}  // namespace porefines::sim
