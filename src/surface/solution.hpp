// SPDX-License-Identifier: MPL-2.0
// The liquid between colloids: kT, Debye length, diffusivity.
#pragma once

#include <cmath>
#include <numbers>

#include "core/types.hpp"

namespace porefines::surface {

// CODATA 2018; the first three are exact.
inline constexpr Real boltzmann = 1.380649e-23;                ///< [J/K]
inline constexpr Real elementary_charge = 1.602176634e-19;     ///< [C]
inline constexpr Real avogadro = 6.02214076e23;                ///< [1/mol]
inline constexpr Real vacuum_permittivity = 8.8541878128e-12;  ///< [F/m]

/// An aqueous electrolyte; water at 20 degrees unless said otherwise.
struct Solution {
  Real temperature = 293.15;  ///< [K]
  Real permittivity = 80.1;   ///< relative
  Real ionic_strength = 1;    ///< [mol/m^3] I = 1/2 sum c z^2; 1 mM = 1 mol/m^3
};

/// kT [J]
[[nodiscard]] constexpr Real thermal_energy(Real temperature) {
  return boltzmann * temperature;
}

/// epsilon_r epsilon_0 [F/m]
[[nodiscard]] constexpr Real absolute_permittivity(const Solution& s) {
  return s.permittivity * vacuum_permittivity;
}

/// Thickness of the double layer [m].
///
///     1/kappa = sqrt(epsilon kT / (2 N_A e^2 I))
///
/// Any mixture of ions: only I counts. Source: Israelachvili, Intermolecular and Surface Forces (2011) 14.13.
/// Test: unit/surface_solution.
[[nodiscard]] inline Real debye_length(const Solution& s) {
  return std::sqrt(absolute_permittivity(s) * thermal_energy(s.temperature) /
                   (2 * avogadro * elementary_charge * elementary_charge * s.ionic_strength));
}

/// Stokes-Einstein: D = kT / (3 pi mu d) [m^2/s] of a sphere of diameter d [m] far from walls.
/// Test: unit/surface_solution.
[[nodiscard]] constexpr Real diffusivity(Real temperature, Real viscosity, Real diameter) {
  return thermal_energy(temperature) / (3 * std::numbers::pi * viscosity * diameter);
}

}  // namespace porefines::surface
