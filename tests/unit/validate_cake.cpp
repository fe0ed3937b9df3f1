// SPDX-License-Identifier: MPL-2.0
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/atomic_file.hpp"
#include "support/scratch.hpp"
#include "validate/read_cake.hpp"

namespace porefines::validate {
namespace {

constexpr CakeFeed feed{.velocity = 1e-3, .viscosity = 2e-3, .diameter = 10e-6};

/// Bins of 4 um: 0.1 ahead of the front, 0.6 behind it, the front's bin in between; a sieve at 162 um.
std::string profile(Real time, Real front) {
  std::string rows;
  for (Real x = 2e-6; x < 200e-6; x += 4e-6) {
    const Real full = std::clamp((x + 2e-6 - front) / 4e-6, 0.0, 1.0);
    const bool sieve = x > 160e-6;
    rows += fmt::format("{},{:.9g},{},{},{}\n", time, x, sieve ? 0 : 0.4 * full,
                        sieve ? 0 : 0.1 + 0.1 * full, sieve ? 0.6 : 1);
  }
  return rows;
}

TEST(ValidateCake, front_share_and_resistance) {
  const test::Scratch folder;
  write_file(folder / "retention.csv",
             "time_s,x_m,retained_fraction,suspended_fraction,porosity_clean\n" +
                 profile(0.1, 130e-6) + profile(0.2, 110e-6));
  write_file(folder / "series.csv", "time_s,pressure_drop_pa\n0.1,30\n0.2,80\n");
  const CakeGrowth found = cake_growth(folder.path(), feed, 0.1, 0.2);
  EXPECT_NEAR(found.share, 0.6, 1e-12);
  EXPECT_NEAR(found.front, 20e-6 / 0.1, 1e-3 * 2e-4);
  EXPECT_NEAR(found.resistance, 50 / (2e-3 * 1e-3 * 20e-6), 2e-3 * 1.25e12);
  EXPECT_TRUE(std::isnan(cake_growth(folder.path(), feed, 0.1, 0.3).front));
}

/// k of 100 um at a solid share of 0.4: 0.216 / (180 0.16) d^2 = 0.0075 d^2.
TEST(ValidateCake, kozeny_and_carman) {
  EXPECT_NEAR(1 / kozeny_carman(0.4, 1e-4), 0.0075e-8, 1e-16);
}

}  // namespace
}  // namespace porefines::validate
