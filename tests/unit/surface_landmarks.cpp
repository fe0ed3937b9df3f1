// SPDX-License-Identifier: MPL-2.0
#include <algorithm>

#include <gtest/gtest.h>

#include "surface/landmarks.hpp"

namespace porefines::surface {
namespace {

constexpr Solution salty{298.15, 78.4, 10};
constexpr Surfaces unlike{.hamaker = 1e-20, .zeta1 = -0.04, .zeta2 = -0.03};
constexpr Real radius = 2.5e-6;
const Real kt = thermal_energy(298.15);

/// references.md D
TEST(Landmarks, barrier_and_secondary_minimum) {
  const Landmarks marks = find_landmarks(make_force_law(salty, unlike), radius);
  ASSERT_TRUE(marks.barrier && marks.secondary);
  EXPECT_NEAR(marks.barrier->energy / kt, 2475.4, 0.05);
  EXPECT_NEAR(marks.barrier->gap, 1.13e-9, 0.5e-11);
  EXPECT_NEAR(marks.secondary->energy / kt, -7.316, 0.5e-3);
  EXPECT_NEAR(marks.secondary->gap, 24.403e-9, 0.5e-12)
      << "printed 24.41, where the energy is 4e-6 kT higher: a grid's place";
  EXPECT_FALSE(marks.primary) << "no Born repulsion, no bottom";
}

/// Against the largest value on a million gaps.
TEST(Landmarks, the_pull_is_the_greatest_attraction_outside_of_the_minimum) {
  Surfaces pair = unlike;
  pair.born_diameter = 0.5e-9;
  const ForceLaw law = make_force_law(salty, pair);
  const Landmarks marks = find_landmarks(law, radius);
  ASSERT_TRUE(marks.primary && marks.barrier && marks.secondary);
  const auto greatest = [&](Real from, Real to) {
    Real pull = 0;
    for (int i = 0; i <= 1000000; ++i) {
      pull = std::max(pull, -radius * law.push(from + (to - from) * i / 1e6).force);
    }
    return pull;
  };
  const Real near = greatest(marks.primary->gap, marks.barrier->gap);
  const Real far = greatest(marks.secondary->gap, 10 * marks.secondary->gap);
  EXPECT_NEAR(marks.primary->pull / near, 1, 1e-8);
  EXPECT_NEAR(marks.secondary->pull / far, 1, 1e-8);
  EXPECT_NEAR(-radius * law.push(marks.primary->pull_gap).force, marks.primary->pull, 1e-12 * near);
  EXPECT_NEAR(law.push(marks.primary->gap).force, 0, 1e-10 * near / radius);
}

/// Without retardation and charge: at sigma/30^(1/6), 6/7 of the attraction there.
TEST(Landmarks, primary_minimum_of_attraction_and_born_repulsion) {
  const ForceLaw law =
      make_force_law(salty, {.hamaker = 1e-20, .wavelength = 1e9, .born_diameter = 0.5e-9});
  const Landmarks marks = find_landmarks(law, radius);
  ASSERT_TRUE(marks.primary);
  const Real gap = 0.5e-9 / std::pow(30.0, 1.0 / 6);
  EXPECT_NEAR(marks.primary->gap / gap, 1, 1e-9);
  EXPECT_NEAR(marks.primary->energy / (-6.0 / 7 * 1e-20 * radius / (6 * gap)), 1, 1e-9);
  EXPECT_FALSE(marks.barrier || marks.secondary);
}

TEST(Landmarks, favourable_surfaces_have_no_barrier) {
  Surfaces pair{.hamaker = 1e-20, .zeta1 = -0.04, .zeta2 = 0.03};
  const Landmarks bottomless = find_landmarks(make_force_law(salty, pair), radius);
  EXPECT_FALSE(bottomless.primary || bottomless.barrier || bottomless.secondary);
  pair.born_diameter = 0.5e-9;
  const Landmarks marks = find_landmarks(make_force_law(salty, pair), radius);
  EXPECT_TRUE(marks.primary);
  EXPECT_FALSE(marks.barrier || marks.secondary);
}

TEST(Landmarks, surfaces_that_only_repel_have_none) {
  const Surfaces pair{.zeta1 = -0.04, .zeta2 = -0.04};
  const Landmarks marks = find_landmarks(make_force_law(salty, pair), radius);
  EXPECT_FALSE(marks.primary || marks.barrier || marks.secondary);
}

/// Weak attraction cannot beat Born repulsion under strong charge: one minimum, far away.
TEST(Landmarks, a_lone_minimum_far_from_contact_is_the_secondary_one) {
  const Surfaces pair{.hamaker = 3e-22, .zeta1 = -0.1, .zeta2 = -0.1, .born_diameter = 1e-9};
  const Landmarks marks = find_landmarks(make_force_law({298.15, 78.4, 100}, pair), radius);
  EXPECT_FALSE(marks.primary || marks.barrier);
  ASSERT_TRUE(marks.secondary);
  EXPECT_GT(marks.secondary->gap, 5e-9);
}

/// Fresh water lifts the barrier and takes the secondary minimum away: why low salinity releases fines.
TEST(Landmarks, salt_lowers_the_barrier_and_deepens_the_secondary_minimum) {
  const auto marks_at = [](Real ionic_strength) {
    return find_landmarks(make_force_law({298.15, 78.4, ionic_strength}, unlike), radius);
  };
  Landmarks before = marks_at(0.1);
  for (const Real ionic_strength : {1.0, 10.0, 100.0}) {
    const Landmarks marks = marks_at(ionic_strength);
    ASSERT_TRUE(marks.barrier && marks.secondary) << ionic_strength;
    EXPECT_LT(marks.barrier->energy, before.barrier->energy);
    EXPECT_LT(marks.secondary->energy, before.secondary->energy);
    EXPECT_LT(marks.secondary->gap, before.secondary->gap);
    before = marks;
  }
}

}  // namespace
}  // namespace porefines::surface
