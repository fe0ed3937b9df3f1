// SPDX-License-Identifier: MPL-2.0
// k, beta and the end of Darcy's law from sweeps whose answer is known.
#include "analysis/forchheimer.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace porefines::analysis {
namespace {

constexpr SweepFluid water{1000, 1e-3};
constexpr Real k = 4e-10;
constexpr Real root = 2e-5 * 1000 / 1e-3;  // Re = root U

TEST(Forchheimer, gives_back_the_two_coefficients) {
  constexpr Real beta = 3e4;
  std::vector<SweepPoint> points;
  for (const Real u : {2.0, 1.0, 0.5, 0.25}) {  // fast, and out of order
    points.push_back({u, 1e-3 * u / k + beta * 1000 * u * u});
  }
  for (const Real u : {1e-6, 2e-6, 4e-6}) {
    points.push_back({u, 1e-3 * u / k});
  }
  const InertiaFit fit = fit_inertia(points, water);
  EXPECT_EQ(fit.slow, 3);
  EXPECT_EQ(fit.fast, 4);
  EXPECT_NEAR(fit.forchheimer_permeability.value / k, 1, 1e-6);
  EXPECT_NEAR(fit.beta.value / beta, 1, 1e-6);
  EXPECT_NEAR(fit.permeability.value / k, 1, 1e-6);
  EXPECT_NEAR(fast_gradient(fit, water, 1) / (1e-3 / k + beta * 1000), 1, 1e-6);
}

/// dp/L = mu U/k (1 + 0.08 Re^2): 5 % at Re = 0.7906.
TEST(Forchheimer, finds_the_cubic_correction_and_where_darcy_ends) {
  std::vector<SweepPoint> points;
  for (Real reynolds = 0.05; reynolds < 2; reynolds *= 1.5) {
    const Real u = reynolds / root;
    points.push_back({u, 1e-3 * u / k * (1 + 0.08 * reynolds * reynolds)});
  }
  const InertiaFit fit = fit_inertia(points, water);
  EXPECT_NEAR(fit.permeability.value / k, 1, 1e-6);
  EXPECT_NEAR(fit.exponent.value, 2, 1e-3);
  EXPECT_NEAR(fit.c, 0.08, 1e-4);
  EXPECT_NEAR(fit.darcy_end_reynolds, std::sqrt(0.05 / 0.08), 1e-4);
  EXPECT_NEAR(slow_gradient(fit, water, 0.5 / root) / (1e-3 * 0.5 / root / k * 1.02), 1, 1e-5);
}

/// Errors of 0.1 % up and down show in the standard errors, and the truth lies within three of them.
TEST(Forchheimer, tells_how_sure_it_is) {
  std::vector<SweepPoint> points;
  Real sign = 1;
  for (Real u = 1e-6; u < 1; u *= 2) {
    points.push_back({u, (1e-3 * u / k + 3e4 * 1000 * u * u) * (1 + 1e-3 * sign)});
    sign = -sign;
  }
  const InertiaFit fit = fit_inertia(points, water);
  EXPECT_GT(fit.beta.error / fit.beta.value, 1e-4);
  EXPECT_LT(std::abs(fit.beta.value - 3e4), 3 * fit.beta.error);
  EXPECT_GT(fit.permeability.error / k, 1e-4);
  EXPECT_LT(std::abs(fit.permeability.value - k), 3 * fit.permeability.error);
}

TEST(Forchheimer, asks_for_a_sweep_that_begins_slowly) {
  std::vector<SweepPoint> points;
  for (const Real u : {0.25, 0.5, 1.0}) {
    points.push_back({u, 1e-3 * u / k + 3e7 * u * u});
  }
  EXPECT_THROW((void)fit_inertia(points, water), InputError);
  EXPECT_THROW((void)fit_inertia({{-1, 1}}, water), InputError);
  const std::vector<SweepPoint> slow{{1e-6, 1e-9 / k}, {2e-6, 2e-9 / k}, {4e-6, 4e-9 / k}};
  EXPECT_TRUE(std::isnan(fit_inertia(slow, water).beta.value));
  EXPECT_TRUE(std::isnan(fit_inertia(slow, water).darcy_end));
}

}  // namespace
}  // namespace porefines::analysis
