// SPDX-License-Identifier: MPL-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "dem/sizes.hpp"

namespace porefines::dem {
namespace {

constexpr std::uint64_t samples = 50'000;

struct Sample {
  const char* name;
  Sizes sizes;
};

Sizes cut(std::variant<Mono, NormalLaw, LognormalLaw, TableLaw> law, Real smallest, Real largest,
          bool by_volume) {
  return {5, smallest, largest, std::move(law), by_volume};
}

const Sample laws[] = {
    {"mono", cut(Mono{}, 0, 0, false)},
    {"normal", cut(NormalLaw{1}, 2, 8, false)},
    {"normal_lopsided", cut(NormalLaw{2}, 4, 12, false)},
    {"normal_by_volume", cut(NormalLaw{1}, 2, 8, true)},
    {"lognormal", cut(LognormalLaw{2}, 1, 20, false)},
    {"lognormal_by_volume", cut(LognormalLaw{2}, 1, 20, true)},
    {"table", cut(TableLaw{{2, 5, 9}, {0.2, 0.5, 0.3}}, 0, 0, false)},
    {"table_by_volume", cut(TableLaw{{2, 5, 9}, {0.2, 0.5, 0.3}}, 0, 0, true)},
};

class SizeLaws : public ::testing::TestWithParam<Sample> {};

/// Draws against the quadrature of the same law: first to third moment, within five standard errors.
TEST_P(SizeLaws, draws_have_the_moments_of_the_law) {
  const Sizes& sizes = GetParam().sizes;
  for (int power = 1; power <= 3; ++power) {
    Real sum = 0;
    for (std::uint64_t id = 0; id < samples; ++id) {
      Draws draws(11, Stream::size, id);
      const Real d = draw_diameter(sizes, draws);
      ASSERT_GE(d, smallest_diameter(sizes));
      ASSERT_LE(d, largest_diameter(sizes));
      sum += std::pow(d, power);
    }
    const Real mean = mean_power(sizes, power);
    const Real variance = std::max(mean_power(sizes, 2 * power) - mean * mean, 0.0);
    EXPECT_NEAR(sum / samples, mean, 5 * std::sqrt(variance / samples) + 1e-9 * mean)
        << "power " << power;
  }
}

INSTANTIATE_TEST_SUITE_P(Dem, SizeLaws, ::testing::ValuesIn(laws),
                         [](const auto& law) { return std::string(law.param.name); });

TEST(Sizes, quadrature_is_exact_where_the_moments_are_known) {
  // Uncut to rounding: E d^n of a lognormal is exp(n m + n^2 s^2 / 2).
  Sizes wide{5, 0.01, 2500, LognormalLaw{2}, false};
  const auto [m, s] = lognormal_parameters(5, 2);
  for (int power = 1; power <= 4; ++power) {
    EXPECT_NEAR(mean_power(wide, power) / std::exp(power * m + power * power * s * s / 2), 1, 1e-6);
  }
  // Weighted by volume, the mean is the one that was asked for: E d^4 / E d^3.
  wide.by_volume = true;
  EXPECT_NEAR(mean_power(wide, 4) / mean_power(wide, 3), 5, 1e-5);
  // A normal law keeps its mean and variance: 1 + 3 s^2 / m^2 of the third moment.
  const Sizes narrow{5, 1, 9, NormalLaw{0.5}, false};
  EXPECT_NEAR(mean_power(narrow, 3) / 125, 1 + 3 * 0.01, 1e-6);
}

TEST(Sizes, a_table_by_volume_gives_back_its_volume_shares) {
  const Sizes sizes{0, 0, 0, TableLaw{{1, 2}, {0.25, 0.75}}, true};
  // 0.25 of volume 1 each, 0.75 of volume 8 each: numbers 8 to 3.
  EXPECT_NEAR(mean_power(sizes, 1), (8 * 1 + 3 * 2) / 11.0, 1e-12);
  EXPECT_NEAR(mean_volume(sizes), std::acos(-1.0) / 6 * (8 * 1 + 3 * 8) / 11.0, 1e-12);
}

}  // namespace
}  // namespace porefines::dem
