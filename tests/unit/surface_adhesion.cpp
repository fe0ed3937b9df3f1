// SPDX-License-Identifier: MPL-2.0
#include <gtest/gtest.h>

#include "surface/adhesion.hpp"

namespace porefines::surface {
namespace {

constexpr Real work = 0.05;
constexpr Real radius = 2.5e-6;

/// references.md D
TEST(Adhesion, pull_off) {
  EXPECT_NEAR(jkr_pull_off(work, radius), 5.8905e-7, 0.5e-11);
  EXPECT_DOUBLE_EQ(dmt_pull_off(work, radius) / jkr_pull_off(work, radius), 4.0 / 3);
}

/// a^3 = R/K [P + 3 pi W R + sqrt(6 pi W R P + (3 pi W R)^2)], K = 4/3 E*: at P = 0, and at the pull-off, where the
/// root vanishes.
TEST(Adhesion, contact_radius_obeys_jkr) {
  const Real modulus = contact_modulus(3.4e9, 0.33, 70e9, 0.2);
  const Real k = 4.0 / 3 * modulus;
  const Real c = 3 * std::numbers::pi * work * radius;
  const Real p = -jkr_pull_off(work, radius);
  EXPECT_NEAR(2 * c * p + c * c, 0, 1e-12 * c * c);
  const Real a = jkr_contact_radius(work, radius, modulus);
  EXPECT_NEAR(a / std::cbrt(radius / k * 2 * c), 1, 1e-12);
  EXPECT_NEAR(std::cbrt(radius / k * (p + c)) * std::cbrt(4.0) / a, 1, 1e-12);
  EXPECT_NEAR(a / dmt_contact_radius(work, radius, modulus), std::cbrt(3.0), 1e-12);
}

TEST(Adhesion, contact_modulus_of_a_hard_wall_is_that_of_the_particle) {
  EXPECT_NEAR(contact_modulus(3.4e9, 0.33, 1e20, 0.2) / (3.4e9 / (1 - 0.33 * 0.33)), 1, 1e-9);
  EXPECT_EQ(contact_modulus(1e9, 0.3, 7e9, 0.2), contact_modulus(7e9, 0.2, 1e9, 0.3));
}

TEST(Adhesion, tabor_number_tells_soft_from_hard) {
  EXPECT_GT(tabor_number(work, 1e-3, 1e6, 0.3e-9), 5);
  EXPECT_LT(tabor_number(1e-4, 1e-8, 70e9, 0.3e-9), 0.1);
  EXPECT_NEAR(tabor_number(0.05, 2.5e-6, 1e9, 1e-9), std::cbrt(6.25e-27) / 1e-9, 1e-12);
}

/// references.md B2, D
TEST(Adhesion, a_sphere_on_a_wall_in_shear) {
  EXPECT_NEAR(shear_moment(1, 1), 43.916, 0.5e-3);
  EXPECT_DOUBLE_EQ(shear_moment(3, 2), 24 * shear_moment(1, 1));
  EXPECT_NEAR(shear_force(2, 3) / (6 * std::numbers::pi * 2 * 9), 1.7005, 1e-12);
}

TEST(Adhesion, at_the_critical_stress_moments_balance) {
  const Real lever = roughness_lever(5e-9, radius);
  const Real holding = 1e-9;
  const Real stress = critical_shear_stress(holding, lever, radius);
  EXPECT_NEAR(shear_couple(stress, radius) + radius * shear_force(stress, radius), holding * lever,
              1e-12 * holding * lever);
  EXPECT_NEAR(stress, 1e-9 * std::sqrt(2 * 5e-9 * 2.5e-6) / (43.916 * 15.625e-18), 1e-4 * stress);
}

/// The chord of the sphere at the height of the asperity.
TEST(Adhesion, lever_of_roughness_is_a_chord) {
  const Real r = 5e-9;
  const Real chord = std::sqrt(radius * radius - (radius - r) * (radius - r));
  EXPECT_NEAR(roughness_lever(r, radius) / chord, 1, r / radius);
}

}  // namespace
}  // namespace porefines::surface
