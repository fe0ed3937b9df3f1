// SPDX-License-Identifier: MPL-2.0
#include "dem/motion.hpp"

#include <limits>

namespace porefines::dem {

namespace {

template <int kicks, bool drift>
Real move(Particles& p, const Vec3& gravity, Real dt) {
  const Real half = dt / 2;
  Real fastest = 0;
  bool finite = true;
  for (std::size_t i = 0; i < p.owned; ++i) {
    const Vec3 g = p.inverse_mass[i] > 0 ? gravity : Vec3{};
    const Vec3 dv = half * (p.inverse_mass[i] * (p.force[i] + p.external_force[i]) + g);
    const Vec3 dw = half * p.inverse_inertia[i] * (p.torque[i] + p.external_torque[i]);
    Vec3 v = p.velocity[i] + dv;
    Vec3 w = p.angular_velocity[i] + dw;
    if constexpr (kicks == 2) {
      v += dv, w += dw;
    }
    p.velocity[i] = v;
    p.angular_velocity[i] = w;
    const Real speed = dot(v, v);
    fastest = speed > fastest ? speed : fastest;
    finite = finite && speed < std::numeric_limits<Real>::max();
    if constexpr (drift) {
      p.position[i] += dt * v;
      p.force[i] = {};
      p.torque[i] = {};
    }
  }
  return finite ? fastest : std::numeric_limits<Real>::infinity();
}

}  // namespace

Real kick_and_drift(Particles& p, const Vec3& gravity, Real dt, int kicks, bool drift) {
  if (drift) {
    return kicks == 2 ? move<2, true>(p, gravity, dt) : move<1, true>(p, gravity, dt);
  }
  return move<1, false>(p, gravity, dt);
}

}  // namespace porefines::dem
