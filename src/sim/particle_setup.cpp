// SPDX-License-Identifier: MPL-2.0
#include "sim/particle_setup.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"
#include "dem/packing.hpp"
#include "sim/particle_walls.hpp"

namespace porefines::sim {
namespace {

Real mean_mass(const config::Particles& species) {
  return species.density * dem::mean_volume(dem_sizes(species.diameter));
}

void require_window(const config::Injection& injection, const dem::Inlet& inlet,
                    const dem::Box& box) {
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != axis_of(injection.face) &&
        !(inlet.low[axis] >= box.low[axis] && inlet.high[axis] <= box.high[axis])) {
      throw InputError(fmt::format(
          "[injection] region: {:.6g} m to {:.6g} m along {} is not within the box, {:.6g} m to "
          "{:.6g} m",
          inlet.low[axis], inlet.high[axis], "xyz"[axis], box.low[axis], box.high[axis]));
    }
  }
}

/// Volume of particles per second [m^3/s], or particles per second.
Real rate_of(const config::Case& the_case, const config::Injection& injection, Real density,
             const dem::Inlet& inlet) {
  if (injection.kind == config::Concentration::rate) {
    return injection.value;
  }
  Real area = 1;
  for (int axis = 0; axis < 3; ++axis) {
    area *= axis == axis_of(injection.face) ? 1 : inlet.high[axis] - inlet.low[axis];
  }
  const Real flow = injection.flow_rate > 0 ? injection.flow_rate : injection.velocity * area;
  return injected_volume(the_case, injection, density, flow);
}

}  // namespace

bool in_wall(const dem::Settings& settings, const Vec3& x) {
  dem::TouchList touches;  // a sphere of no size touches what it is in
  find_touches(settings.walls, x, 0, 0, touches);
  return touches.count > 0;
}

Real injected_volume(const config::Case& the_case, const config::Injection& injection, Real density,
                     Real flow) {
  const Real c = injection.value;
  if (injection.kind == config::Concentration::volume_fraction) {
    return c * flow;
  }
  const Real fluid = the_case.fluid.density;
  return flow * (c / density) / (c / density + (1 - c) / fluid);
}

Vec3 outer_force(const config::Case& the_case, const config::Particles& species, Real radius) {
  const Real excess = (species.density - the_case.fluid.density) * dem::sphere_volume(radius);
  return excess * vec(the_case.gravity) + vec(species.force);
}

dem::Sizes dem_sizes(const config::Sizes& sizes) {
  dem::Sizes out{sizes.mean, sizes.smallest, sizes.largest, dem::Mono{}, sizes.by_volume};
  switch (sizes.law) {
    case config::SizeLaw::mono:
      break;
    case config::SizeLaw::normal:
      out.law = dem::NormalLaw{sizes.deviation};
      break;
    case config::SizeLaw::lognormal:
      out.law = dem::LognormalLaw{sizes.deviation};
      break;
    case config::SizeLaw::table:
      out.law = dem::TableLaw{sizes.diameters, sizes.shares};
      break;
  }
  return out;
}

dem::MaterialTable make_materials(const config::Case& the_case) {
  constexpr Real rolling_damping = 0.3;  // Ai et al. 2011
  const config::Contact& contact = the_case.contact;
  std::vector<dem::Elastic> species;
  for (const config::Particles& p : the_case.particles) {
    species.push_back({p.name, p.young, p.poisson});
  }
  const auto first_wall = static_cast<int>(species.size());
  dem::Elastic wall = species.front();
  wall.young = contact.wall_young > 0 ? contact.wall_young : wall.young;
  wall.poisson = contact.wall_poisson > 0 ? contact.wall_poisson : wall.poisson;
  for (const char* name : {"wall", "smooth wall"}) {
    wall.name = name;
    species.push_back(wall);
  }
  dem::Friction friction{contact.restitution, contact.friction_particle, contact.rolling_friction,
                         rolling_damping};
  dem::MaterialTable table(species, friction);
  for (int a = 0; a < first_wall; ++a) {
    friction.sliding = contact.friction_wall;
    friction.rolling = contact.rolling_friction;
    table.set_pair(a, first_wall, friction);
    friction.sliding = friction.rolling = 0;
    table.set_pair(a, first_wall + 1, friction);
  }
  return table;
}

dem::ContactModel make_contact_model(const config::Case& the_case, Real speed) {
  const config::Contact& contact = the_case.contact;
  dem::ContactModel model;
  if (contact.model == config::ContactModel::linear) {
    const config::Particles& p = the_case.particles.front();
    const Real mass = mean_mass(p) / 2;
    const Real modulus = p.young / (1 - p.poisson * p.poisson) / 2;
    const Real root = std::sqrt(dem::mean_power(dem_sizes(p.diameter), 1) / 4);
    const Real stiffness = 16.0 / 15 * modulus * root *
                           std::pow(15 * mass * speed * speed / (16 * modulus * root), 0.2);
    dem::LinearSpring spring;
    spring.stiffness = contact.stiffness > 0 ? contact.stiffness : stiffness;
    model.normal = spring;
  }
  if (contact.friction_particle == 0 && contact.friction_wall == 0) {
    model.tangential = dem::Unresisted{};
  }
  if (contact.rolling == config::RollingModel::constant_torque) {
    model.rolling = dem::ConstantTorque{};
  } else if (contact.rolling == config::RollingModel::spring_dashpot) {
    model.rolling = dem::RollingSpring{};
  }
  return model;
}

Real expected_speed(const config::Case& the_case, const Vec3& box) {
  if (the_case.contact.top_speed > 0) {
    return the_case.contact.top_speed;
  }
  const Vec3 g = vec(the_case.gravity);
  Real fall = 0;
  Real speed = 0;
  for (int axis = 0; axis < 3; ++axis) {
    fall += std::abs(g[axis]) * box[axis];
  }
  for (const config::Particles& p : the_case.particles) {
    speed = std::max(speed, norm(vec(p.velocity)));
  }
  for (const config::Injection& injection : the_case.injection) {
    speed = std::max(speed, injection.velocity);
  }
  return std::sqrt(speed * speed + 2 * fall);
}

dem::Settings make_settings(const config::Case& the_case, const geom::Sample& sample) {
  return make_settings(the_case, sample, {{}, sample.box.size, the_case.box.periodic});
}

dem::Settings make_settings(const config::Case& the_case, const geom::Sample& sample,
                            const dem::Box& box) {
  dem::Settings settings;
  settings.box = box;
  settings.materials = make_materials(the_case);
  settings.model = make_contact_model(the_case, expected_speed(the_case, box.high - box.low));
  if (config::is_inertial(the_case)) {
    settings.added_density = 0.5 * the_case.fluid.density;  // of a sphere far from others
  } else {
    settings.gravity = vec(the_case.gravity);
  }
  settings.account = !config::is_coupled(the_case);  // energy is lost to the fluid there
  const Walls walls = make_walls(the_case, sample, box.low, box.high);
  settings.walls = walls.surfaces;
  for (const bool smooth : walls.smooth) {
    settings.wall_species.push_back(
        static_cast<std::uint16_t>(the_case.particles.size() + (smooth ? 1 : 0)));
  }
  return settings;
}

Real particles_entering(const dem::Inlet& inlet, Real rate, Real end) {
  const Real amount = rate * dem::open_time(inlet, end);
  return inlet.by_number ? amount : amount / dem::mean_volume(inlet.sizes);
}

std::vector<dem::Inlet> make_inlets(const config::Case& the_case, const dem::Box& box) {
  std::vector<dem::Inlet> inlets;
  for (const config::Injection& injection : the_case.injection) {
    const auto species =
        std::find_if(the_case.particles.begin(), the_case.particles.end(),
                     [&](const config::Particles& p) { return p.name == injection.species; });
    dem::Inlet inlet;
    inlet.face = injection.face;
    inlet.low = injection.region ? vec(injection.region->low) : box.low;
    inlet.high = injection.region ? vec(injection.region->high) : box.high;
    require_window(injection, inlet, box);
    inlet.species = static_cast<std::uint16_t>(species - the_case.particles.begin());
    inlet.density = species->density;
    inlet.sizes = dem_sizes(species->diameter);
    inlet.by_number = injection.kind == config::Concentration::rate;
    inlet.rate = rate_of(the_case, injection, species->density, inlet);
    inlet.start = injection.start;
    inlet.stop = injection.stop > 0 ? injection.stop : the_case.run.end_time;
    inlet.period = injection.pulse_period;
    inlet.duration = injection.pulse_duration;
    inlet.velocity = injection.velocity;
    inlet.seed = the_case.run.random_seed;
    inlet.stream = inlets.size() + 1;
    inlets.push_back(std::move(inlet));
  }
  return inlets;
}

}  // namespace porefines::sim
