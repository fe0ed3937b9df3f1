// SPDX-License-Identifier: MPL-2.0
#include "analysis/shedding.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace porefines::analysis {

TEST(Shedding, of_sines_that_grow) {
  std::vector<Real> time;
  std::vector<Real> drag;
  std::vector<Real> lift;
  for (int i = 0; i <= 1000; ++i) {
    const Real t = 0.1 * i;
    const Real size = std::min(1.0, std::exp((t - 40) / 4));
    const Real phase = 2 * std::numbers::pi * 0.167 * t;
    time.push_back(t);
    lift.push_back(0.01 + 0.3 * size * std::sin(phase));
    drag.push_back(1.37 + 0.01 * size * std::cos(2 * phase));
  }
  const Shedding found = find_shedding(time, drag, lift);
  EXPECT_NEAR(found.frequency, 0.167, 1e-4);
  EXPECT_NEAR(found.drag, 1.37, 1e-4);
  EXPECT_NEAR(found.lift, 0.3, 1e-3);
  EXPECT_EQ(found.periods, 7);
}

TEST(Shedding, none_in_a_steady_stream) {
  const std::vector<Real> time{0, 1, 2, 3, 4, 5, 6, 7, 8};
  const std::vector<Real> drag(9, 2.0);
  const std::vector<Real> lift{0, 1e-5, -1e-5, 1e-5, -1e-5, 1e-5, -1e-5, 1e-5, 0};
  const Shedding found = find_shedding(time, drag, lift);
  EXPECT_EQ(found.frequency, 0);
  EXPECT_NEAR(found.drag, 2, 1e-12);
}

}  // namespace porefines::analysis
