// SPDX-License-Identifier: MPL-2.0
// System::creep, the overdamped integrator of particles in a liquid.
#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"
#include "dem/system.hpp"

namespace porefines::dem {

namespace {

/// Substep times the fastest relaxation rate of the contacts: explicit Euler is stable below 2.
constexpr Real stability = 0.5;

/// A step in which something touches has so many substeps at least, each at most so much longer than
/// the one before: the forces that a cluster hands on settle within it.
constexpr Real fewest = 16;
constexpr Real growth = 2;

/// Steps that may be this much longer than the one before are extrapolated in full.
constexpr Real longest_ahead = 2;

/// W of this step, extrapolated to its middle by Adams-Bashforth; remembers it for the next.
void extrapolate(Particles& p, Real dt) {
  Creeping& c = p.creeping;
  for (std::size_t i = 0; i < p.owned; ++i) {
    if (!(c.resistance[i] > 0 && c.spin_resistance[i] > 0)) {
      throw RunError(fmt::format("particle {}: resistance {:g} N s/m, {:g} N m s: must be positive",
                                 p.id[i], c.resistance[i], c.spin_resistance[i]));
    }
    const Vec3 w = c.free_velocity[i] - c.told_force[i] / c.resistance[i];
    const Vec3 s = c.free_spin[i] - c.told_torque[i] / c.spin_resistance[i];
    // What is held by contacts has no way to extrapolate: there F* follows U*, and would overshoot.
    const bool free = dot(c.told_force[i], c.told_force[i]) == 0;
    const Real ahead =
        free && c.drift_step[i] > 0 ? std::min(dt / c.drift_step[i], longest_ahead) / 2 : 0;
    c.way[i] = w + ahead * (w - c.drift[i]);
    c.way_spin[i] = s + ahead * (s - c.drift_spin[i]);
    c.drift[i] = w, c.drift_spin[i] = s;
    c.mean_force[i] = {}, c.mean_torque[i] = {}, c.mean_velocity[i] = {};
  }
}

/// [m/s] infinite when one is not a number
Real fastest_of(const Particles& p) {
  Real fastest = 0;
  bool finite = true;
  for (std::size_t i = 0; i < p.owned; ++i) {
    const Real speed = dot(p.velocity[i], p.velocity[i]);
    fastest = std::max(fastest, speed);
    finite = finite && speed < std::numeric_limits<Real>::max();
  }
  return finite ? std::sqrt(fastest) : std::numeric_limits<Real>::infinity();
}

/// x += step U
void move(Particles& p, Real step) {
  for (std::size_t i = 0; i < p.owned; ++i) {
    p.position[i] += step * p.velocity[i];
  }
}

/// A substep counts by its length, with the forces at its end: what an implicit rule applies.
void add_to_mean(Particles& p, Real step) {
  for (std::size_t i = 0; i < p.owned; ++i) {
    p.creeping.mean_force[i] += step * p.force[i];
    p.creeping.mean_torque[i] += step * p.torque[i];
    p.creeping.mean_velocity[i] += step * p.velocity[i];
  }
}

void finish_mean(Particles& p, Real elapsed) {
  Creeping& c = p.creeping;
  for (std::size_t i = 0; i < p.owned; ++i) {
    c.mean_force[i] = c.mean_force[i] / elapsed;
    c.mean_torque[i] = c.mean_torque[i] / elapsed;
    c.mean_velocity[i] = c.mean_velocity[i] / elapsed;
    c.drift_step[i] = elapsed;
  }
}

}  // namespace

void System::start_creeping() {
  keep_contacts();
  particles_.creeps = true;
  particles_.resize(particles_.owned);
}

/// The next substep: at most `longest`, and nobody comes too near in it: straight on, or by going along a
/// wall that curves towards it like the particle itself.
Real System::creep_limit(Real longest, Real allowed) {
  const Particles& p = particles_;
  Real step = longest;
  const auto limit = [&](Real gap, Real closing) {
    if (closing > 0) {
      step = std::min(step, (std::max(gap, 0.0) + allowed) / closing);
    }
  };
  pairs_.for_near([&](std::uint32_t i, std::uint32_t j) {
    const Vec3 d = p.position[i] - p.position[j];
    const Real distance = norm(d);
    limit(distance - p.radius[i] - p.radius[j], -dot(d, p.velocity[i] - p.velocity[j]) / distance);
  });
  walls_.for_near(p, window_, moved_, [&](std::uint32_t i, const Touch& touch, int /*species*/) {
    const Vec3 slip = p.velocity[i] - touch.velocity;
    limit(touch.gap, -dot(touch.normal, slip));
    const Real room = p.radius[i] * (std::max(touch.gap, 0.0) + allowed);
    if (step * step * dot(slip, slip) > room) {
      step = std::sqrt(room / dot(slip, slip));
    }
  });
  // Rolling resistance is not in the implicit rule: then the explicit bound holds.
  const bool rolls = !std::holds_alternative<Unresisted>(settings_.model.rolling);
  for (std::size_t i = 0; rolls && i < p.owned; ++i) {
    if (balance_.stiffness(i) > 0) {
      step = std::min(step, stability * p.creeping.resistance[i] / balance_.stiffness(i));
    }
  }
  return comm_.min(step);
}

/// Contact forces where the particles are, their springs stretched over the substep that led there.
void System::creep_forces(Real stretched) {
  particles_.clear_forces();
  contact_forces({stretched, true});
}

CreepReport System::creep(Real dt, const CreepBounds& bounds) {
  if (!particles_.creeps) {
    throw std::logic_error("System::creep before start_creeping");
  }
  if (comm_.max(lists_hold_ ? 0.0 : 1.0) > 0) {
    keep_contacts();
    build_lists(true);
  }
  forces_hold_ = true;
  moves_ = true;
  extrapolate(particles_, dt);
  walls_.forget_sights();
  CreepReport report{0, dt, 0};
  // The largest overlap is that at the end of steps, where the liquid meets it: an edge of a photographed
  // grain that comes into sight too late is left again at once.
  const Real deepest_pair = pairs_.largest_overlap();
  const Real deepest_wall = walls_.largest_overlap();
  creep_forces(0);
  Real longest = dt / fewest;
  Real room = bounds.travel;
  for (Real left = dt; left > 0 && room > 0; ++report.substeps, ++work_.steps) {
    const Real wanted = std::min(left, longest);
    balance_.collect(particles_, pairs_, walls_, settings_.model, settings_.materials, wanted);
    balance_.solve(particles_, wanted, exchange_, comm_);
    exchange_.refresh(particles_, false);
    const Real fastest = comm_.max(fastest_of(particles_));
    const Real near = creep_limit(balance_.none() ? left : wanted, bounds.approach);
    const bool is_last = fastest * near >= room;
    const Real step = is_last ? room / fastest : near;
    move(particles_, step);
    walls_.advance(step);
    update_lists(fastest, step);
    pairs_.reset_largest_overlap(deepest_pair);
    walls_.reset_largest_overlap(deepest_wall);
    creep_forces(step);
    add_to_mean(particles_, step);
    report.shortest = std::min(report.shortest, step);
    report.elapsed += step;
    room = is_last ? 0 : room - fastest * step;
    left = step < left ? left - step : 0;
    longest = std::min(dt / fewest, growth * step);
  }
  finish_mean(particles_, report.elapsed);
  check_walls();
  return report;
}

}  // namespace porefines::dem
