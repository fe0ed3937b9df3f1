// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "dem/material.hpp"
#include "dem/system.hpp"

namespace porefines::dem {

/// Factor <= 1 on Young's modulus with which a sphere pressed onto a twin by `force` [N] overlaps by
/// the share `overlap` of its diameter: F = 4/3 E sqrt(r/2) (2 r overlap)^(3/2). 1 when it is softer
/// already. The largest overlap of a run is System::largest_overlap().
[[nodiscard]] Real softening_for_force(const PairMaterial& pair, Real radius, Real force,
                                       Real overlap);

/// The same for an impact of twins at a closing speed [m/s]: d = (15 m v^2 / (16 E sqrt(R)))^(2/5).
[[nodiscard]] Real softening_for_speed(const PairMaterial& pair, Real radius, Real mass, Real speed,
                                       Real overlap);

/// Stokes number of a particle: its relaxation time 2 rho r^2 / (9 mu) over the flow's time r/U.
/// Below about 0.1 the overdamped integrator is the right one, above it Newton-Euler.
[[nodiscard]] Real stokes_number(Real density, Real radius, Real speed, Real viscosity);

/// How particles move: by inertia (System::advance), or as fast as the liquid lets them (creep).
enum class Integrator { newton_euler, overdamped };

/// Below this Stokes number inertia moves a particle by less than about a tenth of its radius.
inline constexpr Real overdamped_below = 0.1;

/// The integrator for the largest Stokes number of a run; without a liquid (viscosity 0) it is
/// infinite, and there is no resistance to creep against.
[[nodiscard]] constexpr Integrator integrator_for(Real stokes) {
  return stokes < overdamped_below ? Integrator::overdamped : Integrator::newton_euler;
}

/// What the length of a Newton-Euler step depends on, beside the particles.
struct Pace {
  int steps_per_contact = 30;
  Real radius = 0;        ///< [m] of the smallest particle
  Real acceleration = 0;  ///< [m/s^2] largest by gravity and forces
  Real speed = 0;  ///< [m/s] of the fastest particle: System::top_speed, or of who will enter
};

/// The speed of the worst impact to expect soon [m/s]: of two of the fastest head-on, and at least that
/// of a fall from rest through a radius.
[[nodiscard]] Real impact_speed(const Pace& pace);

/// [s] longest step now: the shortest contact's duration / steps_per_contact, and no farther than a
/// twentieth of a radius. Follows the speed of the particles, the same on every rank. Collective.
/// Test: unit/dem_step_size.
[[nodiscard]] Real longest_step(const System& system, const Pace& pace);

}  // namespace porefines::dem
