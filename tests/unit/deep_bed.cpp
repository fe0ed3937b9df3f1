// SPDX-License-Identifier: MPL-2.0
// Deep-bed filtration: the exact solution, and what a fit finds of it.
#include "analysis/deep_bed.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "analysis/least_squares.hpp"
#include "core/error.hpp"
#include "core/random.hpp"

namespace porefines::analysis {
namespace {

constexpr Bed bed{.length = 2e-3, .porosity = 0.4, .feed = 0.005};
constexpr Filtration truth{.lambda = 700, .beta = 150};

/// Standard errors of a straight line: s / sqrt(sum (x - mean)^2) for the slope.
TEST(LeastSquares, finds_a_straight_line_and_its_errors) {
  const std::vector<Real> y{1.1, 2.9, 5.2, 6.8, 9.1};  // x = 0..4
  const auto fit = least_squares(
      [&](const std::vector<Real>& p) {
        std::vector<Real> r;
        for (std::size_t i = 0; i < y.size(); ++i) {
          r.push_back(p[0] + p[1] * static_cast<Real>(i) - y[i]);
        }
        return r;
      },
      {1, 1});
  EXPECT_TRUE(fit.converged);
  EXPECT_NEAR(fit.parameters[1], 1.99, 1e-7);
  EXPECT_NEAR(fit.parameters[0], 1.04, 1e-7);
  const Real s = std::sqrt(fit.sum / 3);
  EXPECT_NEAR(fit.deviations[1], s / std::sqrt(10), 1e-7);
  EXPECT_NEAR(fit.deviations[0], s * std::sqrt(0.2 + 4.0 / 10), 1e-7);
}

/// phi dc/dt + ds/dt + U dc/dx = 0 behind the front, by differences; and the fines that came in are
/// where they should be: retained, suspended or gone.
TEST(DeepBed, solution_satisfies_its_equations) {
  const Real x = 0.3 * bed.length;
  const Real h = 1e-5;
  // per pore volume: ds/dT = lambda L phi c
  const Real rate =
      (retained(bed, truth.lambda, x, 2 + h) - retained(bed, truth.lambda, x, 2 - h)) / (2 * h);
  EXPECT_NEAR(rate, truth.lambda * bed.length * bed.porosity * suspended(bed, truth.lambda, x, 2),
              1e-8 * rate);
  for (const Real volumes : {0.6, 1.0, 3.5}) {
    constexpr int slices = 200000;
    Real held = 0;
    for (int i = 0; i < slices; ++i) {
      const Real at = (i + 0.5) / slices * bed.length;
      held += (retained(bed, truth.lambda, at, volumes) +
               bed.porosity * suspended(bed, truth.lambda, at, volumes)) /
              slices;
    }
    const Real gone = bed.porosity * std::max(0.0, volumes - 1) *
                      suspended(bed, truth.lambda, bed.length, volumes + 1);
    EXPECT_NEAR(held + gone, bed.porosity * bed.feed * volumes, 1e-5 * bed.porosity * bed.feed);
  }
}

TEST(DeepBed, resistance_is_that_of_slices_in_series) {
  for (const Real volumes : {0.4, 1.0, 5.0}) {
    constexpr int slices = 100000;
    Real sum = 0;
    for (int i = 0; i < slices; ++i) {
      const Real at = (i + 0.5) / slices * bed.length;
      sum += (1 + truth.beta * retained(bed, truth.lambda, at, volumes)) / slices;
    }
    EXPECT_NEAR(resistance_ratio(bed, truth, volumes), sum, 1e-6 * sum);
  }
  const Filtration none{.lambda = 0, .beta = 150};
  EXPECT_DOUBLE_EQ(resistance_ratio(bed, none, 2), 1);
}

/// A run as the model would have it, with noise of this relative size.
BedData synthetic(Real noise, std::uint64_t seed) {
  Draws draws(seed, Stream::bootstrap, 0);
  const auto noisy = [&](Real value, Real size) { return value + noise * size * draws.normal(); };
  BedData data;
  data.profile_at = 4;
  for (int i = 0; i < 50; ++i) {
    const Real x = (i + 0.5) / 50 * bed.length;
    data.x.push_back(x);
    data.s.push_back(noisy(retained(bed, truth.lambda, x, data.profile_at), 2e-3));
  }
  for (int i = 1; i <= 80; ++i) {
    const Real volumes = 0.05 * i;
    data.volumes.push_back(volumes);
    data.concentration.push_back(
        noisy(suspended(bed, truth.lambda, bed.length, volumes) / bed.feed, 0.25));
    data.resistance.push_back(noisy(resistance_ratio(bed, truth, volumes), 1));
  }
  return data;
}

TEST(DeepBed, exact_data_give_back_both_coefficients) {
  const BedFit fit = fit_bed(bed, synthetic(0, 1), 0.95, 20, 1);
  EXPECT_NEAR(fit.lambda.value, truth.lambda, 1e-6 * truth.lambda);
  EXPECT_NEAR(fit.beta.value, truth.beta, 1e-6 * truth.beta);
}

/// The stated intervals hold the truth about as often as they say.
/// Of 100, three deviations below 95 are 88.
TEST(DeepBed, intervals_hold_the_truth_as_often_as_they_say) {
  constexpr int runs = 100;
  int lambda = 0;
  int beta = 0;
  int by_deviation = 0;
  for (int i = 0; i < runs; ++i) {
    const BedFit fit = fit_bed(bed, synthetic(0.1, static_cast<std::uint64_t>(i)), 0.95, 100, 1);
    lambda += fit.lambda.low <= truth.lambda && truth.lambda <= fit.lambda.high ? 1 : 0;
    beta += fit.beta.low <= truth.beta && truth.beta <= fit.beta.high ? 1 : 0;
    by_deviation += std::abs(fit.lambda.value - truth.lambda) < 1.96 * fit.lambda_deviation ? 1 : 0;
    EXPECT_NEAR(fit.lambda.value, truth.lambda, 0.05 * truth.lambda);
    EXPECT_NEAR(fit.beta.value, truth.beta, 0.1 * truth.beta);
  }
  EXPECT_GE(lambda, 88);
  EXPECT_GE(beta, 88);
  EXPECT_GE(by_deviation, 88);
}

TEST(DeepBed, nothing_retained_is_said_so) {
  BedData data = synthetic(0, 1);
  data.s.assign(data.s.size(), 0);
  EXPECT_THROW((void)fit_bed(bed, data, 0.95, 20, 1), InputError);
}

}  // namespace
}  // namespace porefines::analysis
