// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <functional>
#include <vector>

#include "core/types.hpp"

namespace porefines::analysis {

/// Residuals of a model for a set of parameters; as many every time.
using Residuals = std::function<std::vector<Real>(const std::vector<Real>& parameters)>;

struct LeastSquares {
  std::vector<Real> parameters;
  std::vector<Real> deviations;  ///< standard errors: sqrt of the diagonal of s^2 (J^T J)^-1
  std::vector<Real> residuals;
  Real sum = 0;  ///< of their squares
  int steps = 0;
  bool converged = false;
};

/// Levenberg-Marquardt with derivatives by central differences.
///
///     (J^T J + m diag(J^T J)) step = -J^T r,   s^2 = sum / (n - p)
///
/// For a few parameters, all of order 1 to 1e3 in their own scale. Source: Marquardt, J. SIAM 11 (1963) 431.
/// Test: unit/deep_bed (an exact solution; a straight line against closed forms).
[[nodiscard]] LeastSquares least_squares(const Residuals& residuals, std::vector<Real> start);

}  // namespace porefines::analysis
