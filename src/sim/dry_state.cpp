// SPDX-License-Identifier: MPL-2.0
#include "sim/dry_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <mpi.h>

#include "analysis/moments.hpp"
#include "core/error.hpp"
#include "dem/packing.hpp"
#include "io/agree.hpp"
#include "sim/particle_setup.hpp"
#include "sim/tracks.hpp"

namespace porefines::sim {
namespace {

constexpr Index longest_stretch = 500;  ///< steps between two looks at signals and open faces

/// The species' force on the owned particles, from `first` on.
void set_forces(DryRun& run) {
  dem::Particles& p = run.system.particles();
  for (std::size_t i = 0; i < p.owned; ++i) {
    const config::Triple& f = run.the_case.particles[p.species[i]].force;
    p.external_force[i] = {f[0], f[1], f[2]};
  }
}

/// Kinetic and potential energy of one particle, contacts left out.
Real energy_of(const DryRun& run, const dem::Body& body) {
  const Real mass = body.density * dem::sphere_volume({body.radius});
  const config::Triple& f = run.the_case.particles[body.species].force;
  return 0.5 * mass * dot(body.velocity, body.velocity) +
         0.2 * mass * body.radius * body.radius *
             dot(body.angular_velocity, body.angular_velocity) -
         dot(mass * run.system.settings().gravity + Vec3{f[0], f[1], f[2]}, body.position);
}

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

/// [m/s] of the fastest particle of all ranks.
Real top_speed(const DryRun& run) {
  const dem::Particles& p = run.system.particles();
  Real square = 0;
  for (std::size_t i = 0; i < p.owned; ++i) {
    square = std::max(square, dot(p.velocity[i], p.velocity[i]));
  }
  return run.comm.max(std::sqrt(square));
}

/// [m] and [m/s^2]: the smallest radius there is, and the largest acceleration by gravity and forces.
struct Scales {
  Real radius = 0;
  Real acceleration = 0;
};

Scales scales_of(const DryRun& run) {
  Scales s{std::numeric_limits<Real>::max(), norm(run.system.settings().gravity)};
  const dem::Particles& p = run.system.particles();
  Real push = 0;
  for (std::size_t i = 0; i < p.owned; ++i) {
    s.radius = std::min(s.radius, p.radius[i]);
    push = std::max(push, norm(p.external_force[i]) * p.inverse_mass[i]);
  }
  for (const dem::Inlet& inlet : run.inlets) {
    s.radius = std::min(s.radius, dem::smallest_diameter(inlet.sizes) / 2);
  }
  s.radius = run.comm.min(s.radius);
  s.acceleration += run.comm.max(push);
  return s;
}

/// [s] of the next sample of any output after now, or the end.
Real next_sample(const DryRun& run) {
  using enum config::OutputKind;
  Real next = run.the_case.run.end_time;
  for (const auto& [kind, written] : {std::pair{summary, run.state.samples},
                                      {tracks, run.state.tracked},
                                      {pictures, run.state.drawn}}) {
    const auto at = static_cast<Real>(std::max<Index>(written, 1));  // the first is written at 0
    if (is_sampled(run.the_case, kind)) {
      next = std::min(next, at * sample_interval(run.the_case, kind));
    }
  }
  return next;
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
                    const par::Communicator& comm, std::vector<std::string>& remarks) {
  const dem::Settings settings = make_settings(the_case, sample);
  const Bed bed = make_bed(the_case, settings);
  remarks = bed.remarks;
  DryRun run{the_case, comm, dem::System(comm, settings), make_inlets(the_case, settings.box), {}};
  run.system.insert(bed.bodies);
  set_forces(run);
  require_apart(run.system, the_case.contact.max_overlap, comm);
  require_open(run);
  run.state.next_id = bed.bodies.size();
  run.state.ledger.placed = static_cast<Index>(bed.bodies.size());
  run.state.inlets.resize(run.inlets.size());
  run.state.energy.start = look(run).energy;
  return run;
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
  const EnergyBook& book = run.state.energy;
  now.energy_lost = book.start + book.injected - book.out - now.energy;
  return now;
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

Stretch choose_stretch(const DryRun& run) {
  const Scales scales = scales_of(run);
  const Real left = next_sample(run) - run.state.time;
  Real speed = top_speed(run);
  for (const dem::Inlet& inlet : run.inlets) {
    speed = std::max(speed, inlet.velocity);
  }
  // An impact as fast as after falling a radius from rest: nothing gentler needs a step of its own.
  const Real slowest = std::sqrt(2 * scales.acceleration * scales.radius);
  const Real impact = std::max({2 * speed, slowest, 1e-9});
  const Real duration = run.system.contact_duration(impact);
  const Real way = scales.radius / impact;  // in which the fastest goes half a radius
  const Real longest =
      std::min({duration / run.the_case.contact.steps_per_contact, way / 10, left});
  Real stretch = std::min(left, static_cast<Real>(longest_stretch) * longest);
  if (!run.inlets.empty()) {
    stretch = std::min(stretch, way);  // or what enters would be late by more than its radius
  }
  const auto count = std::max<Index>(1, static_cast<Index>(std::ceil(stretch / longest - 1e-9)));
  return {stretch / static_cast<Real>(count), count};
}

void advance(DryRun& run, const Stretch& stretch) {
  run.system.advance(stretch.step, stretch.count);
  const Real due = next_sample(run);
  const Real time = run.state.time + stretch.step * static_cast<Real>(stretch.count);
  run.state.time = std::abs(time - due) <= 1e-9 * stretch.step ? due : time;
  run.state.steps += stretch.count;
  run.state.step = stretch.step;
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

void require_healthy(const DryRun& run) {
  const Real overlap = run.system.largest_overlap();
  const Real most = run.the_case.contact.max_overlap;
  if (overlap <= most) {
    return;
  }
  Real young = 0;
  for (const config::Particles& p : run.the_case.particles) {
    young = std::max(young, p.young);
  }
  throw RunError(fmt::format(
      "two particles, or one and a wall, overlap by {:.3g} of a radius at {:.6g} s; [contact] "
      "max_overlap is {:.3g}\ntry young = \"{:.2g} Pa\" (now {:.2g} Pa), since overlaps go with "
      "young^"
      "(-2/5); or a larger max_overlap",
      overlap, run.state.time, most, 1.2 * young * std::pow(overlap / most, 2.5), young));
}

}  // namespace porefines::sim
