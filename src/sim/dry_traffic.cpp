// SPDX-License-Identifier: MPL-2.0
// Particles that come into a dry run and leave it.
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "dem/packing.hpp"
#include "io/agree.hpp"
#include "sim/dry_state.hpp"
#include "sim/particle_setup.hpp"
#include "sim/tracks.hpp"

namespace porefines::sim {
namespace {

/// Kinetic and potential energy of one particle, contacts left out.
Real energy_of(const DryRun& run, const dem::Body& body) {
  const Real mass = body.density * dem::sphere_volume(body.radius);
  const config::Triple& f = run.the_case.particles[body.species].force;
  return 0.5 * mass * dot(body.velocity, body.velocity) +
         0.2 * mass * body.radius * body.radius *
             dot(body.angular_velocity, body.angular_velocity) -
         dot(mass * run.system.settings().gravity + vec(f), body.position);
}

}  // namespace

/// The species' force on the owned particles, from `first` on.
void set_forces(DryRun& run) {
  dem::Particles& p = run.system.particles();
  for (std::size_t i = 0; i < p.owned; ++i) {
    const config::Triple& f = run.the_case.particles[p.species[i]].force;
    p.external_force[i] = run.in_fluid ? Vec3{} : vec(f);
  }
}

void inject_due(DryRun& run, Real from, Real to) {
  Index entered = 0;
  for (std::size_t k = 0; k < run.inlets.size(); ++k) {
    const auto bodies = dem::let_in(run.system, run.comm, run.inlets[k], run.state.inlets[k], from,
                                    to, run.state.next_id);
    entered += static_cast<Index>(bodies.size());
    for (const dem::Body& body : bodies) {
      run.state.energy.injected += energy_of(run, body);
    }
  }
  run.state.ledger.injected += entered;
  if (entered > 0) {
    set_forces(run);
  }
}

std::string take_out(DryRun& run) {
  const dem::Box& box = run.system.settings().box;
  const auto crossed = [&](const dem::Particles& p, std::size_t i) {
    for (int face = 0; face < 6; ++face) {
      const int axis = face / 2;
      const Real x = p.position[i][axis];
      if (!box.periodic[axis] && (face % 2 == 0 ? x < box.low[axis] : x > box.high[axis])) {
        return face;
      }
    }
    return -1;
  };
  const dem::Particles& p = run.system.particles();
  Real leaving = 0;
  std::string through;
  for (std::size_t i = 0; i < p.owned; ++i) {
    const int face = crossed(p, i);
    leaving += face >= 0 ? 1 : 0;
    if (face >= 0 && !run.the_case.box.open[face]) {
      through = fmt::format(
          "particle {} went through the wall {}{} at ({:.6g}, {:.6g}, {:.6g}) m, at {:.3g} m/s\n"
          "its contact was too soft: try a higher young, or more steps_per_contact",
          p.id[i], "xyz"[face / 2], face % 2 == 0 ? '-' : '+', p.position[i].x, p.position[i].y,
          p.position[i].z, norm(p.velocity[i]));
    }
  }
  if (run.comm.max(leaving) == 0) {
    return {};
  }
  io::throw_everywhere(run.comm.handle(), through);
  std::string rows = out_rows(run, [&](std::size_t i) { return crossed(p, i) >= 0; });
  Real energy = 0;
  for (std::size_t i = 0; i < p.owned; ++i) {
    if (crossed(p, i) >= 0) {
      energy += 0.5 * p.mass[i] * dot(p.velocity[i], p.velocity[i]) +
                0.5 * p.inertia(i) * dot(p.angular_velocity[i], p.angular_velocity[i]) -
                dot(p.mass[i] * run.system.settings().gravity + p.external_force[i], p.position[i]);
    }
  }
  run.state.energy.out += run.comm.sum(energy);
  run.state.ledger.out += run.comm.sum(run.system.remove(
      [&](const dem::Particles& all, std::size_t i) { return crossed(all, i) >= 0; }));
  return rows;
}

}  // namespace porefines::sim
