// SPDX-License-Identifier: MPL-2.0
#include "dem/step_size.hpp"

#include <algorithm>

namespace porefines::dem {

Real softening_for_force(const PairMaterial& pair, Real radius, Real force, Real overlap) {
  const Real depth = 2 * radius * overlap;
  const Real modulus = 0.75 * force / (std::sqrt(radius / 2) * std::pow(depth, 1.5));
  return std::min(1.0, modulus / pair.modulus);
}

Real softening_for_speed(const PairMaterial& pair, Real radius, Real mass, Real speed,
                         Real overlap) {
  const Real depth = 2 * radius * overlap;
  const Real modulus =
      15.0 / 16 * (mass / 2) * speed * speed / (std::sqrt(radius / 2) * std::pow(depth, 2.5));
  return std::min(1.0, modulus / pair.modulus);
}

Real stokes_number(Real density, Real radius, Real speed, Real viscosity) {
  return 2 * density * radius * speed / (9 * viscosity);
}

Real impact_speed(const Pace& pace) {
  return std::max({2 * pace.speed, std::sqrt(2 * pace.acceleration * pace.radius), 1e-9});
}

Real longest_step(const System& system, const Pace& pace) {
  const Real impact = impact_speed(pace);
  return std::min(system.contact_duration(impact) / pace.steps_per_contact,
                  pace.radius / impact / 10);
}

}  // namespace porefines::dem
