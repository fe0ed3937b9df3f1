// SPDX-License-Identifier: MPL-2.0
// Printed digits: references.md D.
#include <cmath>

#include <gtest/gtest.h>

#include "surface/collector.hpp"

namespace porefines::surface {
namespace {

constexpr Collector sand{.diameter = 0.6e-3, .porosity = 0.39, .velocity = 9e-6};
constexpr Suspended latex{.diameter = 1e-6,
                          .density = 1050,
                          .hamaker = 1e-20,
                          .temperature = 288.15,
                          .fluid_density = 997,
                          .fluid_viscosity = 1e-3};

TEST(Collector, tufenkji_and_elimelech) {
  const CollectorEfficiency eta = tufenkji_elimelech(filtration_numbers(sand, latex));
  EXPECT_NEAR(eta.diffusion, 0.0167925, 0.5e-7);
  EXPECT_NEAR(eta.interception, 3.780e-4, 0.5e-7);
  EXPECT_NEAR(eta.gravity, 1.8303e-3, 0.5e-7);
  EXPECT_NEAR(eta.total(), 0.0190009, 0.5e-7);
}

TEST(Collector, rajagopalan_and_tien) {
  EXPECT_NEAR(rajagopalan_tien(filtration_numbers(sand, latex)).total(), 0.027092, 0.5e-6);
}

TEST(Collector, the_number_of_attraction_is_made_of_others) {
  const FiltrationNumbers n = filtration_numbers(sand, latex);
  EXPECT_NEAR(n.attraction / (n.van_der_waals / (n.size * n.peclet)), 1, 1e-13);
  EXPECT_NEAR(n.size, 1e-6 / 0.6e-3, 1e-15);
}

TEST(Collector, what_does_not_sink_is_not_met_by_gravity) {
  Suspended oil = latex;
  for (const Real density : {997.0, 850.0}) {
    oil.density = density;
    const FiltrationNumbers n = filtration_numbers(sand, oil);
    EXPECT_LE(n.gravity, 0);
    EXPECT_EQ(tufenkji_elimelech(n).gravity, 0);
    EXPECT_EQ(rajagopalan_tien(n).gravity, 0);
    EXPECT_GT(tufenkji_elimelech(n).total(), 0);
  }
}

/// Fines of about a micron are caught least: smaller ones diffuse, larger ones touch and sink.
TEST(Collector, the_efficiency_has_a_minimum_near_a_micron) {
  const auto total = [](Real diameter) {
    Suspended particle = latex;
    particle.diameter = diameter;
    return tufenkji_elimelech(filtration_numbers(sand, particle)).total();
  };
  EXPECT_GT(total(0.1e-6), 2 * total(1.5e-6));
  EXPECT_GT(total(10e-6), 2 * total(1.5e-6));
}

/// Nothing at the surface; 3/2 A_S N_R^2 + O(N_R^3) near it: the rest falls to an eighth when N_R is halved.
TEST(Collector, happel_interception_is_quadratic_near_the_grain) {
  const Real shape = filtration_numbers(sand, latex).shape;
  EXPECT_NEAR(happel_interception(0.39, 0), 0, 1e-14 * shape);
  const auto rest = [&](Real size) {
    return happel_interception(0.39, size) - 1.5 * shape * size * size;
  };
  EXPECT_NEAR(rest(0.02) / rest(0.01), 8, 0.2);
  EXPECT_NEAR(happel_interception(0.39, 1e-3) / (1.5 * shape * 1e-6), 1, 2e-3);
}

/// At the shell of the cell, r = 1/g, Happel's stream function is that of everything that comes: (r/a)^2.
TEST(Collector, happel_interception_takes_the_whole_cell) {
  const Real g = std::cbrt(1 - 0.39);
  EXPECT_NEAR(happel_interception(0.39, 1 / g - 1), 1 / (g * g), 1e-12);
}

TEST(Collector, filtration_coefficient) {
  EXPECT_NEAR(filtration_coefficient(sand, 0.019), 1.5 * 0.61 * 0.019 / 0.6e-3, 1e-10);
}

}  // namespace
}  // namespace porefines::surface
