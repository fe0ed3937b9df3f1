// SPDX-License-Identifier: MPL-2.0
// Quantiles that confidence intervals need.
#pragma once

#include "core/types.hpp"

namespace porefines::analysis {

/// z with P(Z < z) = p for a standard normal Z, 0 < p < 1: erfc inverted by Newton's method.
[[nodiscard]] Real normal_quantile(Real p);

/// Regularised lower incomplete gamma function P(a, x), a > 0, x >= 0.
///
/// Series below x = a + 1, continued fraction above. Source: Press et al., Numerical Recipes 6.2.
[[nodiscard]] Real gamma_share(Real a, Real x);

/// x with P(X < x) = p for chi-square with so many degrees of freedom, 0 < p < 1; by bisection.
/// Test: unit/statistics (table values).
[[nodiscard]] Real chi_square_quantile(Real p, Real degrees);

}  // namespace porefines::analysis
