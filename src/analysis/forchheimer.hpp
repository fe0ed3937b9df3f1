// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <vector>

#include "core/types.hpp"

namespace porefines::analysis {

/// One steady flow of a sweep.
struct SweepPoint {
  Real velocity = 0;  ///< [m/s] superficial
  Real gradient = 0;  ///< [Pa/m]
};

struct SweepFluid {
  Real density = 0;    ///< [kg/m^3]
  Real viscosity = 0;  ///< [Pa s]
};

/// A value and its standard error; NaN where the sweep cannot tell.
struct Measured {
  Real value;
  Real error;
};

/// What a sweep says about inertia in a porous medium. With Re = rho U sqrt(k)/mu,
///
///     slow:  dp/L = mu U/k (1 + c Re^m)          m = 2: the correction is cubic in U
///     fast:  dp/L = mu U/k_F + beta rho U^2      Forchheimer
///
/// Fast points are 5 % and more above Darcy's law. Slow ones are those less than 1 % above it if there are four,
/// otherwise less than 5 %: m falls from 2 towards 1 on the way to Forchheimer's law. k_F is not k.
struct InertiaFit {
  Measured permeability;  ///< [m^2] k
  Measured exponent;      ///< m; needs four slow points, otherwise 2 is taken and the error is NaN
  Measured forchheimer_permeability;  ///< [m^2] k_F
  Measured beta;                      ///< [1/m]
  Real darcy_end;  ///< [m/s] where the gradient is 5 % above Darcy's; NaN: beyond the sweep
  Real darcy_end_reynolds;  ///< of it
  int slow = 0;             ///< points
  int fast = 0;
  /// Per point, slowest first.
  std::vector<SweepPoint> points;
  std::vector<Real> reynolds;
  std::vector<Real> excess;  ///< gradient over Darcy's, less 1
  Real c = 0;
};

/// The gradient that the two laws of a fit give at a velocity [Pa/m]; NaN where there is no such law.
[[nodiscard]] Real slow_gradient(const InertiaFit& fit, const SweepFluid& fluid, Real velocity);
[[nodiscard]] Real fast_gradient(const InertiaFit& fit, const SweepFluid& fluid, Real velocity);

inline constexpr Real darcy_excess = 0.05;
inline constexpr Real slow_excess = 0.01;

/// Least squares on relative errors of the gradients; k needs three slow points, beta three fast ones.
/// @throws InputError  fewer than three slow points, or a point that flows against its gradient
/// Source: Forchheimer 1901; Mei & Auriault, J. Fluid Mech. 222 (1991) 647 (m = 2 in periodic and isotropic media).
/// Tests: unit/forchheimer, verification/forchheimer.
[[nodiscard]] InertiaFit fit_inertia(std::vector<SweepPoint> points, const SweepFluid& fluid);

}  // namespace porefines::analysis
