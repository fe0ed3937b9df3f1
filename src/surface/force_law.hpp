// SPDX-License-Identifier: MPL-2.0
// Forces between colloids across a gap, by Derjaguin's approximation: V(h; R) = R v(h).
#pragma once

#include <cmath>

#include "surface/solution.hpp"

namespace porefines::surface {

/// R = a1 a2 / (a1 + a2) of two spheres [m]; of a sphere and a plate it is the sphere's radius.
/// Where all energies are R v(h), this is all that a law has to know of its bodies.
/// Valid for h << R and 1/kappa << R. Source: Derjaguin, Kolloid Z. 69 (1934) 155.
[[nodiscard]] constexpr Real reduced_radius(Real a1, Real a2) {
  return a1 / (1 + a1 / a2);
}

/// What a contact feels, per reduced radius; times R: [N] and [N/m].
struct Push {
  Real force = 0;      ///< [N/m] f = -dv/dh, positive pushes apart
  Real stiffness = 0;  ///< [N/m^2] -df/dh, positive where the force falls with the gap
  friend constexpr Push operator+(Push a, const Push& b) {
    return {a.force + b.force, a.stiffness + b.stiffness};
  }
  friend constexpr Push operator*(Real s, const Push& a) { return {s * a.force, s * a.stiffness}; }
};

/// Retarded attraction.
///
///     v = -A / (6 p),   p = h + 14 h^2 / lambda
///
/// A: Hamaker constant [J]; lambda [m]: wavelength of the dispersion, about 100 nm.
/// Without retardation Hamaker's force of a whole sphere is smaller by h/R: 1 % at R/100. Source: Gregory, J. Colloid Interface Sci. 83 (1981) 138.
struct VanDerWaals {
  Real strength = 0;     ///< [J] A/6
  Real retardation = 0;  ///< [1/m] 14/lambda; 0: none

  [[nodiscard]] Real energy(Real h) const { return -strength / (h * (1 + retardation * h)); }
  [[nodiscard]] Push push(Real h) const {
    const Real p = h * (1 + retardation * h);
    const Real slope = 1 + 2 * retardation * h;
    const Real scale = strength / (p * p);
    return {-scale * slope, scale * (2 * retardation - 2 * slope * slope / p)};
  }
};

/// Overlap of two double layers, E = exp(-kappa h).
///
///     constant potential:  v = pi eps [(z1 + z2)^2 ln(1 + E) + (z1 - z2)^2 ln(1 - E)]
///     superposition:       v = 64 pi eps (kT/e)^2 g1 g2 E,   g = tanh(e z / 4 kT)
///
/// z1, z2: zeta potentials [V]. The first is Hogg, Healy & Fuerstenau's form with its logarithms sorted: linear in
/// the potentials, good up to some 60 mV; unequal potentials of one sign attract at short range. The second holds
/// for higher potentials of a 1:1 electrolyte at kappa h > 1, and lies between constant potential and constant charge.
/// Sources: Hogg, Healy & Fuerstenau, Trans. Faraday Soc. 62 (1966) 1638; Gregory, J. Colloid Interface
/// Sci. 51 (1975) 44.
struct DoubleLayer {
  Real kappa = 0;   ///< [1/m]
  Real like = 0;    ///< [N] pi eps (z1 + z2)^2
  Real unlike = 0;  ///< [N] pi eps (z1 - z2)^2
  Real tail = 0;    ///< [N] 64 pi eps (kT/e)^2 g1 g2

  [[nodiscard]] Real energy(Real h) const {
    const Real e = std::exp(-kappa * h);
    return like * std::log1p(e) + unlike * std::log1p(-e) + tail * e;
  }
  [[nodiscard]] Push push(Real h) const {
    const Real e = std::exp(-kappa * h);
    const Real a = 1 / (1 + e);
    const Real b = 1 / (1 - e);
    return {kappa * e * (like * a - unlike * b + tail),
            kappa * kappa * e * (like * a * a - unlike * b * b + tail)};
  }
};

/// Repulsion of the electron shells: gives the contact a minimum of finite depth.
///
///     v = A sigma^6 / (1260 h^7)
///
/// sigma: collision diameter [m], about 0.5 nm. It is Ruckenstein & Prieve's sphere and plate for h << a (they differ by
/// h/(6 a)). Alone with unretarded attraction the minimum lies at sigma / 30^(1/6).
/// Source: Ruckenstein & Prieve, AIChE J. 22 (1976) 276.
struct Born {
  Real strength = 0;  ///< [J m^6] A sigma^6 / 1260

  [[nodiscard]] Real energy(Real h) const { return strength / (h * cube(h * h)); }
  [[nodiscard]] Push push(Real h) const {
    const Real e = energy(h) / h;
    return {7 * e, 56 * e / h};
  }
  [[nodiscard]] static constexpr Real cube(Real x) { return x * x * x; }
};

enum class DoubleLayerModel { constant_potential, superposition };

/// Two surfaces that face each other across the liquid.
struct Surfaces {
  Real hamaker = 0;          ///< [J] A across the liquid
  Real wavelength = 100e-9;  ///< [m]
  Real zeta1 = 0;            ///< [V]
  Real zeta2 = 0;            ///< [V]
  DoubleLayerModel model = DoubleLayerModel::constant_potential;
  Real born_diameter = 0;  ///< [m]; 0: no Born repulsion
};

/// The extended DLVO law of a pair of surfaces; made once, evaluated per contact.
///
/// For gaps h > 0 [m]. A push costs an exponential and a few divisions, without a branch.
/// Test: unit/surface_force_law.
struct ForceLaw {
  VanDerWaals attraction;
  DoubleLayer layers;
  Born born;

  /// [J/m], times R the energy
  [[nodiscard]] Real energy(Real h) const {
    return attraction.energy(h) + layers.energy(h) + born.energy(h);
  }
  [[nodiscard]] Push push(Real h) const {
    return attraction.push(h) + layers.push(h) + born.push(h);
  }
};

[[nodiscard]] ForceLaw make_force_law(const Solution& solution, const Surfaces& pair);

}  // namespace porefines::surface
