// SPDX-License-Identifier: MPL-2.0
#include "dem/motion.hpp"

#include <algorithm>
#include <limits>

namespace porefines::dem {

namespace {

/// Kicks of a particle that something pushes.
template <int kicks, bool drift, bool external>
void kick_pushed(Particles& p, std::size_t i, const Vec3& gravity, Real half) {
  const Vec3 g = p.inverse_mass[i] > 0 ? gravity : Vec3{};
  const Vec3 force = external ? p.force[i] + p.external_force[i] : p.force[i];
  const Vec3 torque = external ? p.torque[i] + p.external_torque[i] : p.torque[i];
  const Vec3 dv = half * (p.inverse_mass[i] * force + g);
  const Vec3 dw = half * p.inverse_inertia[i] * torque;
  const Vec3 v = p.velocity[i] + dv;
  const Vec3 w = p.angular_velocity[i] + dw;
  p.velocity[i] = kicks == 2 ? v + dv : v;
  p.angular_velocity[i] = kicks == 2 ? w + dw : w;
  if constexpr (drift) {
    p.force[i] = {};
    p.torque[i] = {};
  }
}

/// Most particles of a dilute case are pushed by nothing but gravity: the second loop has no branch.
template <int kicks, bool drift, bool external>
Real move(Particles& p, const Vec3& gravity, Real dt) {
  const Real half = dt / 2;
  for (std::size_t i = 0; i < p.owned; ++i) {
    if (external || p.pushed[i] != 0) {
      kick_pushed<kicks, drift, external>(p, i, gravity, half);
    }
  }
  const Vec3 fall = half * gravity;
  Vec3* const velocity = p.velocity.data();
  Vec3* const position = p.position.data();
  const Real* const inverse_mass = p.inverse_mass.data();
  std::uint8_t* const pushed = p.pushed.data();
  const std::size_t owned = p.owned;
  Real fastest = 0;
  int unbound = 0;
#pragma omp simd reduction(max : fastest) reduction(+ : unbound)
  for (std::size_t i = 0; i < owned; ++i) {
    const Real falls = !external && pushed[i] == 0 && inverse_mass[i] > 0 ? 1.0 : 0.0;
    Real x = velocity[i].x + falls * fall.x;
    Real y = velocity[i].y + falls * fall.y;
    Real z = velocity[i].z + falls * fall.z;
    if constexpr (kicks == 2) {
      x += falls * fall.x;
      y += falls * fall.y;
      z += falls * fall.z;
    }
    velocity[i].x = x;
    velocity[i].y = y;
    velocity[i].z = z;
    const Real speed = x * x + y * y + z * z;
    fastest = speed > fastest ? speed : fastest;
    unbound += speed < std::numeric_limits<Real>::max() ? 0 : 1;
    if constexpr (drift) {
      position[i].x += dt * x;
      position[i].y += dt * y;
      position[i].z += dt * z;
      pushed[i] = 0;
    }
  }
  if constexpr (drift) {  // ghosts' sums are nobody's
    std::fill(p.force.begin() + static_cast<std::ptrdiff_t>(owned), p.force.end(), Vec3{});
    std::fill(p.torque.begin() + static_cast<std::ptrdiff_t>(owned), p.torque.end(), Vec3{});
  }
  return unbound == 0 ? fastest : std::numeric_limits<Real>::infinity();
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
