// SPDX-License-Identifier: MPL-2.0
#include "dem/particles.hpp"

#include <algorithm>
#include <numbers>

namespace porefines::dem {

void Particles::resize(std::size_t count) {
  for_arrays(*this, [count](auto& array) { array.resize(count); });
}

void Particles::clear_forces() {
  std::fill(force.begin(), force.end(), Vec3{});
  std::fill(torque.begin(), torque.end(), Vec3{});
}

void Particles::append(const Body& body) {
  resize(owned + 1);
  const std::size_t i = owned++;
  position[i] = body.position;
  velocity[i] = body.velocity;
  angular_velocity[i] = body.angular_velocity;
  radius[i] = body.radius;
  mass[i] = body.density * 4.0 / 3.0 * std::numbers::pi * body.radius * body.radius * body.radius;
  id[i] = body.id;
  species[i] = body.species;
  flags[i] = body.flags;
  set_fixed(i, (body.flags & flag::fixed) != 0);
}

void Particles::set_fixed(std::size_t i, bool fixed) {
  flags[i] = static_cast<std::uint8_t>(fixed ? flags[i] | flag::fixed : flags[i] & ~flag::fixed);
  inverse_mass[i] = fixed ? 0 : 1 / mass[i];
  inverse_inertia[i] = fixed ? 0 : 1 / inertia(i);
}

void Particles::reorder(std::span<const std::uint32_t> order) {
  for_arrays(*this, [order](auto& array) {
    auto old = array;
    array.resize(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
      array[k] = old[order[k]];
    }
  });
}

}  // namespace porefines::dem
