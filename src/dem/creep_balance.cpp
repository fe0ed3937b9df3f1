// SPDX-License-Identifier: MPL-2.0
#include "dem/creep_balance.hpp"

#include <algorithm>
#include <array>

#include "dem/pair_state.hpp"

namespace porefines::dem {

namespace {

/// Slides: at Coulomb's bound, and friction opposes the slip. One that was carried beyond by a long
/// substep, so that friction drives it, is about to stick. While a contact slides, friction keeps its
/// size along the slip and turns with it: across, it is a spring within a short step, and as viscous as
/// bound / |slip| in a long one.
Tangent tangent_of(const ContactModel& model, const PairMaterial& pair, const ContactState& c,
                   const ContactHistory& history, Real dt) {
  constexpr Real nearly = 0.999;
  const NormalResponse r =
      std::visit([&](const auto& normal) { return normal(pair, c); }, model.normal);
  Tangent k{r.stiffness, 0, {}};
  const Real bound = pair.sliding * std::max(r.force, 0.0);
  if (std::holds_alternative<Unresisted>(model.tangential) || bound == 0) {
    return k;
  }
  k.shear = r.shear_stiffness;
  const Vec3& force = history.shear;
  const Real size = norm(force);
  if (size >= nearly * bound && dot(force, c.slip) <= 0) {
    const Vec3 slip = c.slip - dot(c.slip, c.normal) * c.normal;
    k.sliding = force / size;
    k.shear /= 1 + k.shear * dt * norm(slip) / bound;
  }
  return k;
}

/// Velocity of the body's surface at the contact.
Vec3 surface_velocity(const Particles& p, std::size_t i, const Vec3& normal, Real lever) {
  return p.velocity[i] + lever * cross(normal, p.angular_velocity[i]);
}

/// A force at a contact as a body feels it: (force, torque over a).
Six felt(const Vec3& force, const Vec3& normal, Real lever, Real radius) {
  const Vec3 couple = (-lever / radius) * cross(normal, force);
  return {force.x, force.y, force.z, couple.x, couple.y, couple.z};
}

void add_to(Six& sum, Real factor, const Six& six) {
  for (std::size_t x = 0; x < six.size(); ++x) {
    sum[x] += factor * six[x];
  }
}

/// The six columns of a contact's stiffness as one body feels it.
SixBySix stiffness_of(const Tangent& k, const Vec3& normal, Real lever, Real radius) {
  SixBySix out{};
  for (int column = 0; column < 6; ++column) {
    Vec3 unit;
    unit[column % 3] = 1;
    const Vec3 slip = column < 3 ? unit : (lever / radius) * cross(normal, unit);
    const Six answer = felt(k.times(normal, slip), normal, lever, radius);
    for (int row = 0; row < 6; ++row) {
      out[6 * row + column] = answer[row];
    }
  }
  return out;
}

void set_velocity(Particles& p, std::size_t i, const Six& motion) {
  p.velocity[i] = {motion[0], motion[1], motion[2]};
  p.angular_velocity[i] = (1 / p.radius[i]) * Vec3{motion[3], motion[4], motion[5]};
}

}  // namespace

/// Null for ghosts and for what is held.
CreepBalance::Body* CreepBalance::body_of(const Particles& p, std::size_t i) {
  if (i >= p.owned || p.inverse_mass[i] == 0) {
    return nullptr;
  }
  if (place_[i] < 0) {
    place_[i] = static_cast<std::int32_t>(bodies_.size());
    bodies_.push_back({static_cast<std::uint32_t>(i)});
  }
  return &bodies_[static_cast<std::size_t>(place_[i])];
}

void CreepBalance::collect(const Particles& p, const PairContacts& pairs, const WallContacts& walls,
                           const ContactModel& model, const MaterialTable& materials, Real dt) {
  place_.assign(p.size(), -1);
  stiffness_.assign(p.size(), 0);
  bodies_.clear(), links_.clear();
  const auto meet = [&](std::size_t i, const Arm& arm, const Tangent& k, const Vec3& known) {
    if (Body* body = body_of(p, i)) {
      const SixBySix own = stiffness_of(k, arm.normal, arm.lever, p.radius[i]);
      for (std::size_t x = 0; x < own.size(); ++x) {
        body->stiffness[x] += own[x];
      }
      add_to(body->given, 1, felt(k.times(arm.normal, known), arm.normal, arm.lever, p.radius[i]));
      stiffness_[i] += std::max(k.normal, 1.75 * k.shear);  // sliding and turning both give way
    }
  };
  pairs.for_touching([&](std::uint32_t i, std::uint32_t j, const ContactHistory& history) {
    const ContactState c = pair_state(p, i, j);
    const PairMaterial& pair = materials.pair(p.species[i], p.species[j]);
    const Tangent k = tangent_of(model, pair, c, history, dt);
    const Arm at_i{c.normal, p.radius[i] - c.overlap / 2};
    const Arm at_j{-1.0 * c.normal, p.radius[j] - c.overlap / 2};
    const auto held = [&](std::size_t q, const Arm& arm) {
      return p.inverse_mass[q] == 0 ? surface_velocity(p, q, arm.normal, arm.lever) : Vec3{};
    };
    meet(i, at_i, k, held(j, at_j));
    meet(j, at_j, k, held(i, at_i));
    if (p.inverse_mass[i] > 0 && p.inverse_mass[j] > 0) {
      links_.push_back({i, j, at_i, at_j, k});
    }
  });
  walls.for_standing(
      [&](std::uint32_t i, const Touch& touch, int species, const ContactHistory& history) {
        const ContactState c = wall_state(p, i, touch);
        Tangent k = tangent_of(model, materials.pair(p.species[i], species), c, history, dt);
        k.normal *= touch.share, k.shear *= touch.share;
        meet(i, {c.normal, p.radius[i] - c.overlap / 2}, k, touch.velocity);
      });
}

/// Right-hand sides into `residual`, preconditioners, and the velocities of the substep before.
void CreepBalance::begin(const Particles& p, Real dt) {
  const Creeping& c = p.creeping;
  for (Body& b : bodies_) {
    const std::size_t i = b.particle;
    const Real a = p.radius[i];
    const Real turning = c.spin_resistance[i] / (a * a);
    const Vec3 push = c.resistance[i] * c.way[i] + p.force[i] + p.external_force[i];
    const Vec3 turn = turning * a * c.way_spin[i] + (1 / a) * (p.torque[i] + p.external_torque[i]);
    for (Real& value : b.stiffness) {
      value *= dt;
    }
    for (int d = 0; d < 3; ++d) {
      b.stiffness[7 * d] += c.resistance[i];
      b.stiffness[7 * (3 + d)] += turning;
      b.residual[d] = push[d] + dt * b.given[d];
      b.residual[3 + d] = turn[d] + dt * b.given[3 + d];
      b.motion[d] = p.velocity[i][d];
      b.motion[3 + d] = a * p.angular_velocity[i][d];
    }
    b.lower = cholesky(b.stiffness, 0);
  }
}

/// answer = A x, where velocities of particles and ghosts hold x.
void CreepBalance::apply(Particles& p, Real dt, Six Body::*x) {
  for (Body& b : bodies_) {
    b.answer = times(b.stiffness, b.*x);
  }
  for (const Link& link : links_) {
    const auto other = [&](std::size_t i, const Arm& at, std::size_t j, const Arm& across) {
      if (i < p.owned) {
        const Vec3 force =
            link.tangent.times(at.normal, surface_velocity(p, j, across.normal, across.lever));
        add_to(bodies_[static_cast<std::size_t>(place_[i])].answer, -dt,
               felt(force, at.normal, at.lever, p.radius[i]));
      }
    };
    other(link.i, link.at_i, link.j, link.at_j);
    other(link.j, link.at_j, link.i, link.at_i);
  }
}

/// What touches nothing goes as its drag balances what pulls it.
void CreepBalance::drift_alone(Particles& p) const {
  const Creeping& c = p.creeping;
  for (std::size_t i = 0; i < p.owned; ++i) {
    if (place_[i] < 0 && p.inverse_mass[i] > 0) {
      p.velocity[i] = c.way[i] + (p.force[i] + p.external_force[i]) / c.resistance[i];
      p.angular_velocity[i] =
          c.way_spin[i] + (p.torque[i] + p.external_torque[i]) / c.spin_resistance[i];
    }
  }
}

/// Velocities of particles and ghosts from x, and answer = A x.
void CreepBalance::show(Particles& p, Real dt, Six Body::*x, Exchange& exchange) {
  for (const Body& b : bodies_) {
    set_velocity(p, b.particle, b.*x);
  }
  exchange.refresh(p, false);
  apply(p, dt, x);
}

/// Preconditioned residual into `answer`.
/// @return the work left in it, of this rank
Real CreepBalance::precondition() {
  Real left = 0;
  for (Body& b : bodies_) {
    b.answer = solved(b.lower, b.residual);
    left += dot(b.residual, b.answer);
  }
  return left;
}

/// The residual below which a solve has done enough. Zero where nothing pushes anywhere. Collective.
Real CreepBalance::enough(const Particles& p, const par::Communicator& comm) const {
  constexpr Real accuracy = 1e-6;    // of the work of all that pushes at the moment
  constexpr Real negligible = 1e-7;  // of what the liquid would do if nothing touched
  std::array<Real, 2> work{};
  for (const Body& b : bodies_) {
    const Vec3& way = p.creeping.way[b.particle];
    work[0] += dot(b.residual, solved(b.lower, b.residual));
    work[1] += p.creeping.resistance[b.particle] * dot(way, way);
  }
  comm.sum(work);
  return work[0] == 0 ? 0 : accuracy * accuracy * work[0] + negligible * negligible * work[1];
}

int CreepBalance::solve(Particles& p, Real dt, Exchange& exchange, const par::Communicator& comm) {
  constexpr int most = 60;
  drift_alone(p);
  begin(p, dt);
  const Real bound = enough(p, comm);
  int n = 0;
  if (bound == 0) {  // nothing pushes: what touches rests
    for (Body& b : bodies_) {
      b.motion = {};
    }
  } else {
    show(p, dt, &Body::motion, exchange);
    for (Body& b : bodies_) {
      add_to(b.residual, -1, b.answer);
    }
    Real left = comm.sum(precondition());
    for (Real before = 0; n < most && left > bound; ++n) {
      for (Body& b : bodies_) {
        Six direction = b.answer;
        add_to(direction, n > 0 ? left / before : 0, b.direction);
        b.direction = direction;
      }
      before = left;
      show(p, dt, &Body::direction, exchange);
      Real curvature = 0;
      for (const Body& b : bodies_) {
        curvature += dot(b.direction, b.answer);
      }
      const Real length = before / comm.sum(curvature);
      for (Body& b : bodies_) {
        add_to(b.motion, length, b.direction);
        add_to(b.residual, -length, b.answer);
      }
      left = comm.sum(precondition());
    }
  }
  for (const Body& b : bodies_) {
    set_velocity(p, b.particle, b.motion);
  }
  return n;
}

}  // namespace porefines::dem
