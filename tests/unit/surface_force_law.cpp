// SPDX-License-Identifier: MPL-2.0
// Printed digits: references.md D, a sphere of 2.5 um and a plate in 10 mM at 25 degrees.
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "surface/force_law.hpp"

namespace porefines::surface {
namespace {

constexpr Solution salty{298.15, 78.4, 10};
constexpr Surfaces unlike{.hamaker = 1e-20, .zeta1 = -0.04, .zeta2 = -0.03};
constexpr Real radius = 2.5e-6;

Surfaces with(DoubleLayerModel model, Real born_diameter = 0) {
  Surfaces pair = unlike;
  pair.model = model;
  pair.born_diameter = born_diameter;
  return pair;
}

/// Every kind of law that there is.
std::vector<ForceLaw> laws() {
  using enum DoubleLayerModel;
  return {make_force_law(salty, with(constant_potential)),
          make_force_law(salty, with(superposition)),
          make_force_law(salty, with(constant_potential, 0.5e-9)),
          make_force_law({293.15, 80.1, 0.1}, {.hamaker = 0, .zeta1 = 0.02, .zeta2 = -0.05})};
}

TEST(ForceLaw, energies_of_a_sphere_and_a_plate) {
  const ForceLaw law = make_force_law(salty, unlike);
  const Real scale = radius / thermal_energy(298.15);
  EXPECT_NEAR(scale * law.attraction.energy(1e-9), -887.904, 0.5e-3);
  EXPECT_NEAR(scale * law.attraction.energy(5e-9), -119.08354, 0.5e-5)
      << "printed -119.083, cut instead of rounded: 1e-20 2.5e-6/(6 5e-9 1.7 kT)";
  EXPECT_NEAR(scale * law.attraction.energy(20e-9), -13.3186, 0.5e-4);
  EXPECT_NEAR(scale * law.layers.energy(1e-9), 3349.97, 0.5e-2);
  EXPECT_NEAR(scale * law.layers.energy(5e-9), 1117.27, 0.5e-2);
  EXPECT_NEAR(scale * law.layers.energy(20e-9), 8.8283, 0.5e-4);
  EXPECT_DOUBLE_EQ(law.energy(5e-9), law.attraction.energy(5e-9) + law.layers.energy(5e-9));
}

/// Central differences err by the square of their step: a quarter when it is halved, and nothing is left at zero.
TEST(ForceLaw, force_and_stiffness_are_derivatives) {
  for (const ForceLaw& law : laws()) {
    for (const Real h : {0.3e-9, 1e-9, 7e-9, 60e-9}) {
      const auto force = [&](Real d) { return (law.energy(h - d) - law.energy(h + d)) / (2 * d); };
      const auto stiffness = [&](Real d) {
        return (law.push(h - d).force - law.push(h + d).force) / (2 * d);
      };
      const Push push = law.push(h);
      const Real d = h / 20;
      EXPECT_NEAR((force(d) - push.force) / (force(d / 2) - push.force), 4, 0.1) << h;
      EXPECT_NEAR((stiffness(d) - push.stiffness) / (stiffness(d / 2) - push.stiffness), 4, 0.1)
          << h;
      const Real scale = 1e-6 * std::abs(push.force);
      EXPECT_NEAR((4 * force(d / 64) - force(d / 32)) / 3, push.force, scale) << h;
    }
  }
}

TEST(ForceLaw, swapping_the_surfaces_changes_nothing) {
  for (const auto model : {DoubleLayerModel::constant_potential, DoubleLayerModel::superposition}) {
    Surfaces pair = with(model);
    const ForceLaw law = make_force_law(salty, pair);
    std::swap(pair.zeta1, pair.zeta2);
    EXPECT_DOUBLE_EQ(make_force_law(salty, pair).push(3e-9).force, law.push(3e-9).force);
  }
  EXPECT_DOUBLE_EQ(reduced_radius(1e-6, 4e-6), reduced_radius(4e-6, 1e-6));
  EXPECT_DOUBLE_EQ(reduced_radius(1e-6, 4e-6), 0.8e-6);
}

TEST(ForceLaw, a_huge_sphere_is_a_plate) {
  EXPECT_NEAR(reduced_radius(1e-6, 1) / 1e-6, 1, 1e-6 * (1 + 1e-6));
  EXPECT_EQ(reduced_radius(1e-6, std::numeric_limits<Real>::infinity()), 1e-6);
}

/// A/6h^2 near by, A lambda/42 h^3 far away: a power of the gap more.
TEST(ForceLaw, retardation_steepens_the_tail) {
  const ForceLaw law = make_force_law(salty, {.hamaker = 1e-20});
  EXPECT_NEAR(law.push(1e-12).force / (-1e-20 / 6 / 1e-24), 1, 1e-6);
  EXPECT_NEAR(law.push(1e-4).force / (-1e-20 * 100e-9 / 42 / 1e-12), 1, 1e-3);
  const ForceLaw plain = make_force_law(salty, {.hamaker = 1e-20, .wavelength = 1e9});
  EXPECT_NEAR(plain.push(1e-6).force / (-1e-20 / 6 / 1e-12), 1, 1e-12);
}

/// Hamaker 1937, sphere and plate: F = A/6 [a/h^2 + a/(h + 2a)^2 - 1/h + 1/(h + 2a)].
TEST(ForceLaw, attraction_of_a_whole_sphere_is_smaller_by_the_gap_over_the_radius) {
  const ForceLaw law = make_force_law(salty, {.hamaker = 6, .wavelength = 1e9});
  for (const Real h : {1e-4, 1e-2}) {
    const Real whole = 1 / (h * h) + 1 / ((h + 2) * (h + 2)) - 1 / h + 1 / (h + 2);
    EXPECT_NEAR((-law.push(h).force / whole - 1) / h, 1, 0.01) << h;
  }
}

/// Derjaguin: f = 2 pi times the energy of plates, W = eps kappa/2 [(z1^2 + z2^2)(1 - coth) + 2 z1 z2/sinh].
TEST(ForceLaw, constant_potential_is_that_of_plates) {
  const ForceLaw law = make_force_law(salty, unlike);
  const Real kappa = law.layers.kappa;
  for (const Real x : {0.05, 0.3, 1.0, 4.0}) {
    const Real plates =
        absolute_permittivity(salty) * kappa / 2 *
        ((0.04 * 0.04 + 0.03 * 0.03) * (1 - 1 / std::tanh(x)) + 2 * 0.04 * 0.03 / std::sinh(x));
    EXPECT_NEAR(law.layers.push(x / kappa).force / (2 * std::numbers::pi * plates), 1, 1e-12) << x;
  }
}

TEST(ForceLaw, constant_potential_attracts_where_potentials_differ) {
  const ForceLaw law = make_force_law(salty, unlike);
  const Real turn = -std::log(2 * 0.04 * 0.03 / (0.04 * 0.04 + 0.03 * 0.03)) / law.layers.kappa;
  EXPECT_LT(law.layers.push(0.99 * turn).force, 0);
  EXPECT_GT(law.layers.push(1.01 * turn).force, 0);
}

/// At low potentials and more than a few Debye lengths both models are 4 pi eps z1 z2 exp(-kappa h).
TEST(ForceLaw, both_double_layers_have_the_same_tail) {
  Surfaces pair{.zeta1 = 1e-3, .zeta2 = 2e-3};
  const ForceLaw potential = make_force_law(salty, pair);
  pair.model = DoubleLayerModel::superposition;
  const ForceLaw sum = make_force_law(salty, pair);
  const Real h = 12 / sum.layers.kappa;
  EXPECT_NEAR(potential.layers.energy(h) / sum.layers.energy(h), 1, 1e-3);
  EXPECT_NEAR(sum.layers.energy(h) / (4 * std::numbers::pi * absolute_permittivity(salty) * 1e-3 *
                                      2e-3 * std::exp(-12.0)),
              1, 1e-3);
}

/// 64 pi eps (kT/e)^2 g1 g2 exp(-kappa h) of high potentials, by hand: below Debye and Hueckel's 4 pi eps z1 z2.
TEST(ForceLaw, superposition_saturates) {
  const ForceLaw law = make_force_law(
      salty, {.zeta1 = 0.2, .zeta2 = -0.2, .model = DoubleLayerModel::superposition});
  const Real h = 1 / law.layers.kappa;
  const Real thermal = 25.6926e-3;
  const Real g = std::tanh(0.2 / (4 * thermal));
  const Real scale = 4 * std::numbers::pi * 78.4 * 8.854188e-12 * std::exp(-1.0);
  EXPECT_NEAR(law.layers.energy(h) / (-16 * scale * thermal * thermal * g * g), 1, 1e-5);
  EXPECT_LT(std::abs(law.layers.energy(h)), 0.3 * scale * 0.2 * 0.2);
}

/// Ruckenstein & Prieve's sphere and plate: A s^6/7560 [(8a + h)/(2a + h)^7 + (6a - h)/h^7].
TEST(ForceLaw, born_repulsion_is_that_of_a_sphere_and_a_plate) {
  const ForceLaw law = make_force_law(salty, with(DoubleLayerModel::superposition, 0.5e-9));
  const Real a = 100e-9;
  for (const Real h : {0.3e-9, 1e-9}) {
    const Real whole = 1e-20 * std::pow(0.5e-9, 6) / 7560 *
                       ((8 * a + h) / std::pow(2 * a + h, 7) + (6 * a - h) / std::pow(h, 7));
    EXPECT_NEAR(a * law.born.energy(h) / whole, 1 + h / (6 * a), 1e-5) << h;
  }
}

}  // namespace
}  // namespace porefines::surface
