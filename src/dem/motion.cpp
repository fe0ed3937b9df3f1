// SPDX-License-Identifier: MPL-2.0
#include "dem/motion.hpp"

#include <algorithm>
#include <limits>

namespace porefines::dem {

namespace {

template <int kicks, bool drift, bool external>
Real move(Particles& p, const Vec3& gravity, Real dt) {
  const Real half = dt / 2;
  Real fastest = 0;
  bool finite = true;
  for (std::size_t i = 0; i < p.owned; ++i) {
    const Vec3 g = p.inverse_mass[i] > 0 ? gravity : Vec3{};
    Vec3 dv = half * g;
    if (external || p.pushed[i] != 0) {  // most particles of a dilute case are not touched by any
      const Vec3 force = external ? p.force[i] + p.external_force[i] : p.force[i];
      const Vec3 torque = external ? p.torque[i] + p.external_torque[i] : p.torque[i];
      dv = half * (p.inverse_mass[i] * force + g);
      const Vec3 dw = half * p.inverse_inertia[i] * torque;
      const Vec3 w = p.angular_velocity[i] + dw;
      p.angular_velocity[i] = kicks == 2 ? w + dw : w;
      if constexpr (drift) {
        p.force[i] = {};
        p.torque[i] = {};
        p.pushed[i] = 0;
      }
    }
    Vec3 v = p.velocity[i] + dv;
    if constexpr (kicks == 2) {
      v += dv;
    }
    p.velocity[i] = v;
    const Real speed = dot(v, v);
    fastest = speed > fastest ? speed : fastest;
    finite &= speed < std::numeric_limits<Real>::max();
    if constexpr (drift) {
      p.position[i] += dt * v;
    }
  }
  if constexpr (drift) {  // ghosts' sums are nobody's
    std::fill(p.force.begin() + static_cast<std::ptrdiff_t>(p.owned), p.force.end(), Vec3{});
    std::fill(p.torque.begin() + static_cast<std::ptrdiff_t>(p.owned), p.torque.end(), Vec3{});
  }
  return finite ? fastest : std::numeric_limits<Real>::infinity();
}

template <int kicks, bool drift>
Real move(Particles& p, const Kick& kick) {
  return kick.external ? move<kicks, drift, true>(p, kick.gravity, kick.dt)
                       : move<kicks, drift, false>(p, kick.gravity, kick.dt);
}

}  // namespace

bool has_external_forces(const Particles& p) {
  const auto any = [&p](const AlignedVector<Vec3>& values) {
    return std::any_of(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(p.owned),
                       [](const Vec3& v) { return v != Vec3{}; });
  };
  return any(p.external_force) || any(p.external_torque);
}

Real kick_and_drift(Particles& p, const Kick& kick, int kicks, bool drift) {
  if (drift) {
    return kicks == 2 ? move<2, true>(p, kick) : move<1, true>(p, kick);
  }
  return move<1, false>(p, kick);
}

}  // namespace porefines::dem
