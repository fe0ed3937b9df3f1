// SPDX-License-Identifier: MPL-2.0
#include "analysis/distributions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace porefines::analysis {
namespace {

constexpr Real precision = std::numeric_limits<Real>::epsilon();
constexpr int most_terms = 10000;

/// exp(-x) x^a / Gamma(a)
Real front(Real a, Real x) {
  return std::exp(a * std::log(x) - x - std::lgamma(a));
}

Real by_series(Real a, Real x) {
  Real term = 1 / a;
  Real sum = term;
  for (int n = 1; n < most_terms && term > sum * precision; ++n) {
    term *= x / (a + n);
    sum += term;
  }
  return sum * front(a, x);
}

/// 1 - P by Lentz's method.
Real by_fraction(Real a, Real x) {
  constexpr Real tiny = std::numeric_limits<Real>::min() / precision;
  Real b = x + 1 - a;
  Real c = 1 / tiny;
  Real d = 1 / b;
  Real h = d;
  Real change = 0;
  for (int n = 1; n < most_terms && std::abs(change - 1) > precision; ++n) {
    const Real an = -n * (n - a);
    b += 2;
    const auto away = [](Real value) { return std::abs(value) < tiny ? tiny : value; };
    d = 1 / away(an * d + b);
    c = away(b + an / c);
    change = d * c;
    h *= change;
  }
  return h * front(a, x);
}

}  // namespace

Real normal_quantile(Real p) {
  Real z = 0;
  for (int n = 0; n < 100; ++n) {
    const Real density = std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi);
    const Real miss = 0.5 * std::erfc(-z / std::numbers::sqrt2) - p;
    const Real step = std::clamp(miss / std::max(density, 1e-300), -0.5, 0.5);
    z -= step;
    if (std::abs(step) < 1e-14 * (1 + std::abs(z))) {
      break;
    }
  }
  return z;
}

Real gamma_share(Real a, Real x) {
  if (x <= 0) {
    return 0;
  }
  return x < a + 1 ? by_series(a, x) : 1 - by_fraction(a, x);
}

Real chi_square_quantile(Real p, Real degrees) {
  Real low = 0;
  Real high = degrees + 1;
  while (gamma_share(degrees / 2, high / 2) < p) {
    high *= 2;
  }
  for (int n = 0; n < 200 && high - low > 1e-14 * high; ++n) {
    const Real middle = 0.5 * (low + high);
    (gamma_share(degrees / 2, middle / 2) < p ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace porefines::analysis
