// SPDX-License-Identifier: MPL-2.0
// How many of the particles that flow towards a grain of a filter meet it.
#pragma once

#include "core/types.hpp"

namespace porefines::surface {

/// A filter of equal spheres.
struct Collector {
  Real diameter = 0;  ///< [m] of a grain
  Real porosity = 0;
  Real velocity = 0;  ///< [m/s] superficial
};

/// Who flows towards it, in what.
struct Suspended {
  Real diameter = 0;         ///< [m]
  Real density = 0;          ///< [kg/m^3]
  Real hamaker = 0;          ///< [J] particle and grain across the liquid
  Real temperature = 0;      ///< [K]
  Real fluid_density = 0;    ///< [kg/m^3]
  Real fluid_viscosity = 0;  ///< [Pa s]
  Real gravity = 9.81;       ///< [m/s^2]
};

/// Dimensionless groups; a: radius of the particle, D: its diffusivity.
struct FiltrationNumbers {
  Real
      shape;  ///< A_S = 2 (1 - g^5)/w, w = 2 - 3 g + 3 g^5 - 2 g^6, g^3 = 1 - porosity (Happel's cell)
  Real size;           ///< N_R = d_p/d_c
  Real peclet;         ///< N_Pe = U d_c/D
  Real van_der_waals;  ///< N_vdW = A/kT
  Real attraction;     ///< N_A = A/(12 pi mu a^2 U) = N_vdW/(N_R N_Pe)
  Real gravity;        ///< N_G = 2/9 a^2 (rho_p - rho_f) g/(mu U); below zero the particle rises
};
[[nodiscard]] FiltrationNumbers filtration_numbers(const Collector& collector,
                                                   const Suspended& particle);

/// Shares of the particles in the grain's cross-section pi d_c^2/4 that meet it, if every meeting lasts.
struct CollectorEfficiency {
  Real diffusion;
  Real interception;
  Real gravity;  ///< 0 where the particle does not sink
  [[nodiscard]] Real total() const { return diffusion + interception + gravity; }
};

/// Correlation of trajectories with retardation by the grain.
///
///     2.4 A_S^(1/3) N_R^-0.081 N_Pe^-0.715 N_vdW^0.052 + 0.55 A_S N_R^1.675 N_A^0.125
///       + 0.22 N_R^-0.24 N_G^1.11 N_vdW^0.053
///
/// Favourable conditions; A > 0. Source: Tufenkji & Elimelech, Environ. Sci. Technol. 38 (2004) 529, eq. 17.
/// Test: unit/surface_collector.
[[nodiscard]] CollectorEfficiency tufenkji_elimelech(const FiltrationNumbers& n);

/// The older correlation, with N_Lo = 4/3 N_A.
///
///     4 A_S^(1/3) N_Pe^(-2/3) + A_S N_Lo^(1/8) N_R^(15/8) + 0.00338 A_S N_G^1.2 N_R^-0.4
///
/// Sources: Rajagopalan & Tien, AIChE J. 22 (1976) 523, with the coefficients of Logan et al., J. Environ. Eng. 121 (1995) 869.
[[nodiscard]] CollectorEfficiency rajagopalan_tien(const FiltrationNumbers& n);

/// Points that follow Happel's stream lines up to a distance of their radius: exact.
///
///     K1/r + K2 r + K3 r^2 + K4 r^4,   r = 1 + N_R,   K = (1, -3 - 2 g^5, 2 + 3 g^5, -g^5)/w
///
/// 3/2 A_S N_R^2 for small particles. Source: Happel, AIChE J. 4 (1958) 197.
[[nodiscard]] Real happel_interception(Real porosity, Real size);

/// lambda = 3 (1 - porosity) eta / (2 d_c) [1/m] of -dc/dx = lambda c, the coefficient of `porefines fit`, where every meeting
/// lasts. Source: Yao, Habibian & O'Melia, Environ. Sci. Technol. 5 (1971) 1105.
[[nodiscard]] Real filtration_coefficient(const Collector& collector, Real efficiency);

}  // namespace porefines::surface
