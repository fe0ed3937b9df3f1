// SPDX-License-Identifier: MPL-2.0
// Spheres that stick by contact, and the shear that rolls them off.
#pragma once

#include <cmath>
#include <numbers>

#include "core/types.hpp"

namespace porefines::surface {

/// 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2 [Pa]
[[nodiscard]] constexpr Real contact_modulus(Real young1, Real poisson1, Real young2,
                                             Real poisson2) {
  return 1 / ((1 - poisson1 * poisson1) / young1 + (1 - poisson2 * poisson2) / young2);
}

/// Force that parts two bodies of reduced radius R [m] and work of adhesion W [J/m^2], in newtons: 3/2 pi W R of
/// soft large bodies (Johnson, Kendall & Roberts), 2 pi W R of hard small ones (Derjaguin, Muller & Toporov).
/// tabor_number says which. Sources: Proc. R. Soc. A 324 (1971) 301; J. Colloid Interface Sci. 53 (1975) 314.
/// Test: unit/surface_adhesion.
[[nodiscard]] constexpr Real jkr_pull_off(Real work, Real radius) {
  return 1.5 * std::numbers::pi * work * radius;
}
[[nodiscard]] constexpr Real dmt_pull_off(Real work, Real radius) {
  return 2 * std::numbers::pi * work * radius;
}

/// Radius of the contact without load [m]; E* [Pa].
///
///     JKR: (9 pi W R^2 / (2 E*))^(1/3)      DMT: (3 pi W R^2 / (2 E*))^(1/3)
///
/// The JKR contact shrinks by 4^(1/3) until it parts.
[[nodiscard]] inline Real jkr_contact_radius(Real work, Real radius, Real modulus) {
  return std::cbrt(4.5 * std::numbers::pi * work * radius * radius / modulus);
}
[[nodiscard]] inline Real dmt_contact_radius(Real work, Real radius, Real modulus) {
  return std::cbrt(1.5 * std::numbers::pi * work * radius * radius / modulus);
}

/// (R W^2 / (E*^2 z^3))^(1/3), z [m] the range of the attraction, about 0.3 nm: JKR holds above 5, DMT below 0.1.
/// Source: Tabor, J. Colloid Interface Sci. 58 (1977) 2.
[[nodiscard]] inline Real tabor_number(Real work, Real radius, Real modulus, Real range) {
  return std::cbrt(radius * work * work / (modulus * modulus)) / range;
}

/// Lever arm of a sphere of radius a [m] that rests against asperities of height r: its centre is
/// sqrt(2 r a) behind them. For r << a. Source: Hubbe, Colloids Surf. 12 (1984) 151.
[[nodiscard]] inline Real roughness_lever(Real roughness, Real radius) {
  return std::sqrt(2 * roughness * radius);
}

/// What a shear flow of wall stress tau [Pa] does to a sphere of radius a that is held on a wall:
///
///     F = 1.7005 6 pi tau a^2,   T = 0.94399 4 pi tau a^3 about the centre,   T + F a about the contact
///
/// Creeping flow, a small against the channel; no lift. Source: O'Neill, Chem. Eng. Sci. 23 (1968) 1293; Goldman,
/// Cox & Brenner, Chem. Eng. Sci. 22 (1967) 653. Test: unit/surface_adhesion.
[[nodiscard]] constexpr Real shear_force(Real stress, Real radius) {
  return 1.7005 * 6 * std::numbers::pi * stress * radius * radius;
}
[[nodiscard]] constexpr Real shear_couple(Real stress, Real radius) {
  return 0.94399 * 4 * std::numbers::pi * stress * radius * radius * radius;
}
[[nodiscard]] constexpr Real shear_moment(Real stress, Real radius) {
  return shear_couple(stress, radius) + radius * shear_force(stress, radius);
}

/// Wall stress [Pa] at which the moment of the flow about the contact equals that of the force that holds the sphere,
/// F l: above it the sphere rolls. It slides first where l/a is above 1.37 times the coefficient of friction.
/// @param holding  [N] F, adhesion and weight together
/// @param lever    [m] l: contact radius, or roughness_lever
[[nodiscard]] constexpr Real critical_shear_stress(Real holding, Real lever, Real radius) {
  return holding * lever / shear_moment(1, radius);
}

}  // namespace porefines::surface
