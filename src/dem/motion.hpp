// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "dem/particles.hpp"

namespace porefines::dem {

/// What drives a step beside the contacts.
struct Kick {
  Vec3 gravity;           ///< [m/s^2]
  Real dt = 0;            ///< [s]
  bool external = false;  ///< external forces or torques are not all zero
};

[[nodiscard]] bool has_external_forces(const Particles& particles);

/// v += kicks * dt/2 (F/m + g), w += kicks * dt/2 T/I, in `kicks` (1 or 2) half steps; then, with
/// drift, x += dt v. Velocity Verlet is kick, drift, forces, kick: the last and the next first kick
/// are taken in one pass over memory, with the same bits as one after the other.
/// Clears the forces when it drifts: the next evaluation adds to zero.
/// @return the largest speed squared [m^2/s^2]; infinite when a velocity is not a number
Real kick_and_drift(Particles& particles, const Kick& kick, int kicks, bool drift);

}  // namespace porefines::dem
