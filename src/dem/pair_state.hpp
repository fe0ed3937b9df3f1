// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "dem/contact_law.hpp"
#include "dem/particles.hpp"
#include "dem/touch.hpp"

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

/// Contact of particle i with a wall or grain.
[[nodiscard]] inline ContactState wall_state(const Particles& p, std::uint32_t i,
                                             const Touch& touch) {
  const Vec3 spin = p.angular_velocity[i];
  ContactState c;
  c.normal = touch.normal;
  c.overlap = -touch.gap;
  c.slip = p.velocity[i] - touch.velocity - cross((p.radius[i] - c.overlap / 2) * spin, c.normal);
  c.spin = spin;
  // A hollow curved as the sphere itself would have no curvature left: keep a little.
  c.radius = 1 / std::max(1 / p.radius[i] + touch.curvature, 0.01 / p.radius[i]);
  c.mass = 1 / p.inverse_mass[i];
  c.inertia = 1 / p.inverse_inertia[i];
  return c;
}

}  // namespace porefines::dem
