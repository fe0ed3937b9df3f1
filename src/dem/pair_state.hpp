// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "dem/contact_law.hpp"
#include "dem/particles.hpp"

namespace porefines::dem {

/// Contact of particles i and j as the law sees it, one at a time: for sums and records, not for
/// the loop of forces (pair_contacts.cpp does the same in batches).
[[nodiscard]] inline ContactState pair_state(const Particles& p, std::size_t i, std::size_t j) {
  const Vec3 d = p.position[i] - p.position[j];
  const Real distance = norm(d);
  ContactState c;
  c.normal = d / distance;
  c.overlap = std::max(p.radius[i] + p.radius[j] - distance, 0.0);
  const Real arm_i = p.radius[i] - c.overlap / 2;
  const Real arm_j = p.radius[j] - c.overlap / 2;
  c.slip = p.velocity[i] - p.velocity[j] -
           cross(arm_i * p.angular_velocity[i] + arm_j * p.angular_velocity[j], c.normal);
  c.spin = p.angular_velocity[i] - p.angular_velocity[j];
  c.radius = p.radius[i] * p.radius[j] / (p.radius[i] + p.radius[j]);
  c.mass = 1 / (p.inverse_mass[i] + p.inverse_mass[j]);
  c.inertia = 1 / (p.inverse_inertia[i] + p.inverse_inertia[j]);
  return c;
}

}  // namespace porefines::dem
