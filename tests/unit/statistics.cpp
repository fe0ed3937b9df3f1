// SPDX-License-Identifier: MPL-2.0
// Statistics of repeats against tables and published examples.
#include <cmath>

#include <gtest/gtest.h>

#include "analysis/bands.hpp"
#include "analysis/distributions.hpp"
#include "analysis/survival.hpp"
#include "core/random.hpp"

namespace porefines::analysis {
namespace {

TEST(Distributions, agree_with_tables) {
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-12);
  EXPECT_NEAR(normal_quantile(0.001), -3.090232306167813, 1e-12);
  EXPECT_NEAR(chi_square_quantile(0.975, 2), -2 * std::log(0.025), 1e-10);  // exponential
  EXPECT_NEAR(chi_square_quantile(0.95, 10), 18.307038053, 1e-8);
  EXPECT_NEAR(chi_square_quantile(0.025, 40), 24.433039, 1e-5);
  EXPECT_NEAR(gamma_share(0.5, 2), std::erf(std::sqrt(2.0)), 1e-13);
  EXPECT_NEAR(gamma_share(3, 9), 1 - std::exp(-9.0) * (1 + 9 + 40.5), 1e-13);
}

/// Remission of leukaemia under 6-MP, weeks (Freireich et al. 1963; the survivor function and its
/// standard errors as printed in Kleinbaum & Klein, Survival Analysis, and in R's survfit).
std::vector<Lifetime> six_mp() {
  std::vector<Lifetime> lives;
  for (const int t : {6, 6, 6, 7, 10, 13, 16, 22, 23}) {
    lives.push_back({static_cast<Real>(t), true});
  }
  for (const int t : {6, 9, 10, 11, 17, 19, 20, 25, 32, 32, 34, 35}) {
    lives.push_back({static_cast<Real>(t), false});
  }
  return lives;
}

TEST(Survival, of_the_six_mp_patients_is_the_published_one) {
  const auto steps = kaplan_meier(six_mp(), 0.95);
  ASSERT_EQ(steps.size(), 7);
  const std::vector<Real> survival{0.857, 0.807, 0.753, 0.690, 0.627, 0.538, 0.448};
  const std::vector<Real> errors{0.0764, 0.0869, 0.0963, 0.1068, 0.1141, 0.1282, 0.1346};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_NEAR(steps[i].survival, survival[i], 5e-4);
    EXPECT_NEAR(steps[i].deviation, errors[i], 5e-5);
  }
  EXPECT_EQ(steps[0].at_risk, 21);
  EXPECT_EQ(steps[0].events, 3);
  EXPECT_NEAR(steps[0].low, 0.620, 5e-4);  // conf.type = "log-log"
  EXPECT_NEAR(steps[0].high, 0.952, 5e-4);
}

TEST(Survival, falls_to_zero_with_the_last_one) {
  const auto steps = kaplan_meier({{1, true}, {2, true}}, 0.95);
  ASSERT_EQ(steps.size(), 2);
  EXPECT_DOUBLE_EQ(steps[0].survival, 0.5);
  EXPECT_DOUBLE_EQ(steps[1].survival, 0);
  EXPECT_DOUBLE_EQ(steps[1].low, 0);
  EXPECT_DOUBLE_EQ(steps[1].high, steps[0].high);
}

TEST(Exponential, of_the_six_mp_patients_is_the_published_one) {
  const ExponentialFit fit = fit_exponential(six_mp(), 0.95);
  EXPECT_EQ(fit.events, 9);
  EXPECT_DOUBLE_EQ(fit.exposure, 359);
  EXPECT_NEAR(1 / fit.mean, 0.0251, 5e-5);
  EXPECT_NEAR(fit.low, 2 * 359 / 34.1696, 1e-3);  // chi-square tables: 0.975 of 20, 0.025 of 18
  EXPECT_NEAR(fit.high, 2 * 359 / 8.23075, 1e-3);
}

TEST(Exponential, without_an_event_has_no_upper_end) {
  const ExponentialFit fit = fit_exponential({{10, false}, {20, false}}, 0.95);
  EXPECT_TRUE(std::isinf(fit.mean));
  EXPECT_TRUE(std::isinf(fit.high));
  EXPECT_NEAR(fit.low, -30 / std::log(0.025), 1e-9);
}

/// 400 ensembles of 20, censored at the mean: the interval holds the truth 95 times of a hundred.
TEST(Exponential, interval_covers_as_often_as_it_says) {
  constexpr int ensembles = 400;
  int covered = 0;
  for (int e = 0; e < ensembles; ++e) {
    Draws draws(7, Stream::bootstrap, static_cast<std::uint64_t>(e));
    std::vector<Lifetime> lives;
    for (int i = 0; i < 20; ++i) {
      const Real life = -3 * std::log(1 - draws.uniform());
      lives.push_back({std::min(life, 3.0), life < 3});
    }
    const ExponentialFit fit = fit_exponential(lives, 0.95);
    covered += fit.low <= 3 && 3 <= fit.high ? 1 : 0;
  }
  EXPECT_GE(covered, ensembles * 0.93);  // cautious: not below 95 % by more than two deviations
}

TEST(Wilson, is_the_published_interval) {
  const Proportion p = wilson(81, 263, 0.95);  // Newcombe 1998, method 3
  EXPECT_NEAR(p.low, 0.2553, 5e-5);
  EXPECT_NEAR(p.high, 0.3662, 5e-5);
  const Proportion none = wilson(0, 20, 0.95);
  EXPECT_DOUBLE_EQ(none.low, 0);
  EXPECT_NEAR(none.high, 0.1611, 5e-5);
}

TEST(Bands, of_straight_lines_are_straight_lines) {
  const std::vector<Sampled> curves{{{0, 2}, {1, 1}}, {{0, 1, 3}, {1, 0.9, 0.7}}};
  const auto points = bands(curves, 5, 0.95, 200, 1);
  ASSERT_EQ(points.size(), 5);
  EXPECT_DOUBLE_EQ(points.back().x, 2);  // where the shorter one ends
  EXPECT_NEAR(points.back().mean.value, 0.9, 1e-12);
  EXPECT_NEAR(points.back().lower, 0.82, 1e-12);
  EXPECT_NEAR(points.back().median, 0.9, 1e-12);
  EXPECT_NEAR(points[1].mean.value, 0.975, 1e-12);
}

TEST(Bands, a_clogged_run_keeps_its_last_value) {
  const std::vector<Sampled> curves{{{0, 1}, {1, 0.1}, true}, {{0, 4}, {1, 1}}};
  const auto points = bands(curves, 3, 0.95, 200, 1);
  EXPECT_DOUBLE_EQ(points.back().x, 4);
  EXPECT_EQ(points.back().members, 2);
  EXPECT_NEAR(points.back().mean.value, 0.55, 1e-12);
}

/// The bootstrap's spread of a mean is that of theory: sd / sqrt(n) with the divisor n.
TEST(Bands, bootstrap_interval_has_the_width_of_theory) {
  std::vector<Real> values;
  for (int i = 0; i < 100; ++i) {
    values.push_back(i % 10);
  }
  const Estimate e = bootstrap_mean(values, 0.95, 4000, 3);
  const Real half = 1.96 * std::sqrt(8.25 / 100);
  EXPECT_DOUBLE_EQ(e.value, 4.5);
  EXPECT_NEAR(e.high - e.value, half, 0.06 * half);
  EXPECT_NEAR(e.value - e.low, half, 0.06 * half);
}

}  // namespace
}  // namespace porefines::analysis
