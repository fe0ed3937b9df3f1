// SPDX-License-Identifier: MPL-2.0
#include "dem/system.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.hpp"

namespace porefines::dem {

System::System(const par::Communicator& comm, Settings settings)
    : comm_(comm), settings_(std::move(settings)) {}

void System::insert(std::span<const Body> bodies) {
  for (const Body& body : bodies) {
    if (!(body.radius > 0) || !(body.density > 0)) {
      throw InputError(
          fmt::format("particle {}: radius {:g} m, density {:g} kg/m^3: both must be "
                      "positive",
                      body.id, body.radius, body.density));
    }
    if (settings_.blocks.owner(settings_.box.wrapped(body.position)) == comm_.rank()) {
      particles_.append(body);
    }
  }
  lists_hold_ = false;
}

Index System::remove(const std::function<bool(const Particles&, std::size_t)>& gone) {
  std::vector<std::uint32_t> order;
  for (std::size_t i = 0; i < particles_.owned; ++i) {
    if (!gone(particles_, i)) {
      order.push_back(static_cast<std::uint32_t>(i));
    }
  }
  const std::size_t left = particles_.owned - order.size();
  particles_.reorder(order);
  particles_.owned = order.size();
  lists_hold_ = false;
  return static_cast<Index>(left);
}

void System::rebuild() {
  lists_hold_ = false;
}

void System::find_pairs() {
  pairs_.clear();
  for (std::uint32_t i = 0; i < particles_.owned; ++i) {
    for (std::uint32_t j = i + 1; j < particles_.owned; ++j) {
      pairs_.push_back({i, j, {}});
    }
  }
  lists_hold_ = true;
  ++work_.rebuilds;
}

void System::contact_forces(Real dt) {
  Particles& p = particles_;
  std::fill(p.force.begin(), p.force.end(), Vec3{});
  std::fill(p.torque.begin(), p.torque.end(), Vec3{});
  with_law(settings_.model, [&](const auto& law) {
    for (auto& [i, j, history] : pairs_) {
      const Vec3 d = p.position[i] - p.position[j];
      const Real distance = norm(d);
      ContactState c;
      c.overlap = p.radius[i] + p.radius[j] - distance;
      if (c.overlap <= 0) {
        history = {};
        continue;
      }
      c.normal = d / distance;
      const Real arm_i = p.radius[i] - c.overlap / 2;
      const Real arm_j = p.radius[j] - c.overlap / 2;
      c.slip = p.velocity[i] - p.velocity[j] -
               cross(arm_i * p.angular_velocity[i] + arm_j * p.angular_velocity[j], c.normal);
      c.spin = p.angular_velocity[i] - p.angular_velocity[j];
      c.radius = p.radius[i] * p.radius[j] / (p.radius[i] + p.radius[j]);
      c.mass = 1 / (p.inverse_mass[i] + p.inverse_mass[j]);
      c.inertia = 1 / (p.inverse_inertia[i] + p.inverse_inertia[j]);
      const PairMaterial& pair = settings_.materials.pair(p.species[i], p.species[j]);
      const ContactForce f = law(pair, c, dt, history);
      p.force[i] += f.force;
      p.force[j] -= f.force;
      const Vec3 turning = cross(c.normal, f.force);
      p.torque[i] += f.couple - arm_i * turning;
      p.torque[j] -= f.couple + arm_j * turning;
      largest_overlap_ = std::max(largest_overlap_, c.overlap / std::min(p.radius[i], p.radius[j]));
    }
  });
}

void System::advance(Real dt, Index steps) {
  Particles& p = particles_;
  const auto kick = [&] {
    for (std::size_t i = 0; i < p.owned; ++i) {
      const Vec3 g = p.is_fixed(i) ? Vec3{} : settings_.gravity;
      p.velocity[i] += dt / 2 * (p.inverse_mass[i] * (p.force[i] + p.external_force[i]) + g);
      p.angular_velocity[i] += dt / 2 * p.inverse_inertia[i] * (p.torque[i] + p.external_torque[i]);
    }
  };
  for (Index step = 0; step < steps; ++step, ++work_.steps) {
    kick();
    for (std::size_t i = 0; i < p.owned; ++i) {
      p.position[i] += dt * p.velocity[i];
    }
    if (!lists_hold_) {
      find_pairs();
    }
    contact_forces(dt);
    kick();
  }
}

Real System::largest_overlap() const {
  return comm_.max(largest_overlap_);
}

Totals System::totals() const {
  Totals t;
  const Particles& p = particles_;
  for (std::size_t i = 0; i < p.owned; ++i) {
    t.particles += 1;
    t.momentum += p.mass[i] * p.velocity[i];
    t.angular_momentum +=
        p.mass[i] * cross(p.position[i], p.velocity[i]) + p.inertia(i) * p.angular_velocity[i];
    t.kinetic += 0.5 * p.mass[i] * dot(p.velocity[i], p.velocity[i]);
    t.rotational += 0.5 * p.inertia(i) * dot(p.angular_velocity[i], p.angular_velocity[i]);
    t.potential -= p.mass[i] * dot(settings_.gravity, p.position[i]);
  }
  return t;
}

}  // namespace porefines::dem
