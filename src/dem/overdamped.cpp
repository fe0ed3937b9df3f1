// SPDX-License-Identifier: MPL-2.0
// System::creep, the overdamped integrator of particles in a liquid.
#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"
#include "dem/pair_state.hpp"
#include "dem/system.hpp"

namespace porefines::dem {

namespace {

/// Substep times the fastest relaxation rate of the contacts: explicit Euler is stable below 2.
constexpr Real stability = 0.5;

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
    c.drift[i] = w, c.drift_spin[i] = s, c.drift_step[i] = dt;
    c.mean_force[i] = {}, c.mean_torque[i] = {};
  }
}

/// Velocities that balance the present contact forces. Held particles keep theirs.
void balance(Particles& p) {
  const Creeping& c = p.creeping;
  for (std::size_t i = 0; i < p.owned; ++i) {
    if (p.inverse_mass[i] > 0) {
      p.velocity[i] = c.way[i] + (p.force[i] + p.external_force[i]) / c.resistance[i];
      p.angular_velocity[i] =
          c.way_spin[i] + (p.torque[i] + p.external_torque[i]) / c.spin_resistance[i];
    }
  }
}

/// x += step U; the forces of the substep count by its share of the step.
/// @return the largest speed [m/s]; infinite when one is not a number
Real move(Particles& p, Real step, Real share) {
  Real fastest = 0;
  bool finite = true;
  for (std::size_t i = 0; i < p.owned; ++i) {
    const Real speed = dot(p.velocity[i], p.velocity[i]);
    fastest = std::max(fastest, speed);
    finite = finite && speed < std::numeric_limits<Real>::max();
    p.position[i] += step * p.velocity[i];
    p.creeping.mean_force[i] += share * p.force[i];
    p.creeping.mean_torque[i] += share * p.torque[i];
  }
  return finite ? std::sqrt(fastest) : std::numeric_limits<Real>::infinity();
}

}  // namespace

void System::start_creeping() {
  keep_contacts();
  particles_.creeps = true;
  particles_.resize(particles_.owned);
}

/// The next substep: stable for the stiffness of the contacts, and no pair comes too near in it.
Real System::creep_limit(Real left, Real allowed) {
  const Particles& p = particles_;
  stiffness_.assign(p.size(), 0);
  Real step = left;
  const auto limit = [&](Real gap, Real closing) {
    if (closing > 0) {
      step = std::min(step, (std::max(gap, 0.0) + allowed) / closing);
    }
  };
  const auto stiffness = [&](const PairMaterial& pair, const ContactState& c) {
    const auto r = std::visit([&](const auto& n) { return n(pair, c); }, settings_.model.normal);
    return std::max(r.stiffness, 1.75 * r.shear_stiffness);  // sliding and turning both give way
  };
  pairs_.for_near([&](std::uint32_t i, std::uint32_t j) {
    const Vec3 d = p.position[i] - p.position[j];
    const Real gap = norm(d) - p.radius[i] - p.radius[j];
    limit(gap, -dot(d, p.velocity[i] - p.velocity[j]) / norm(d));
    if (gap < 0) {
      const PairMaterial& pair = settings_.materials.pair(p.species[i], p.species[j]);
      const Real k = stiffness(pair, pair_state(p, i, j));
      stiffness_[i] += k, stiffness_[j] += k;
    }
  });
  walls_.for_near(p, window_, moved_, [&](std::uint32_t i, const Touch& touch, int species) {
    limit(touch.gap, -dot(touch.normal, p.velocity[i] - touch.velocity));
    if (touch.gap < 0) {
      const PairMaterial& pair = settings_.materials.pair(p.species[i], species);
      stiffness_[i] += stiffness(pair, wall_state(p, i, touch));
    }
  });
  for (std::size_t i = 0; i < p.owned; ++i) {
    if (stiffness_[i] > 0) {
      step = std::min(step, stability * p.creeping.resistance[i] / stiffness_[i]);
    }
  }
  return comm_.min(step);
}

CreepReport System::creep(Real dt, Real allowed_approach) {
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
  CreepReport report{0, dt};
  Real before = 0;  // the substep over which springs have stretched
  for (Real left = dt; left > 0; ++report.substeps, ++work_.steps) {
    particles_.clear_forces();
    contact_forces({before, true});
    balance(particles_);
    exchange_.refresh(particles_, false);
    const Real step = creep_limit(left, allowed_approach);
    const Real fastest = move(particles_, step, step / dt);
    walls_.advance(step);
    update_lists(fastest, step);
    report.shortest = std::min(report.shortest, step);
    left = step < left ? left - step : 0;
    before = step;
  }
  check_walls();
  return report;
}

}  // namespace porefines::dem
