// SPDX-License-Identifier: MPL-2.0
#include "analysis/permeability.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/drag.hpp"
#include "analysis/flux.hpp"

namespace porefines::analysis {
namespace {

/// Plates a depth h apart: Q/A = h^2/12 mu * drop/L.
TEST(Permeability, of_plates_is_a_twelfth_of_the_depth_squared) {
  const Real h = 20e-6;
  const Real mu = 1e-3;
  const Real drop = 12;
  const Real length = 1e-3;
  const Real area = 5e-8;
  const Real rate = area * h * h / (12 * mu) * drop / length;
  EXPECT_NEAR(darcy_permeability({rate, area, length, drop, mu}) / darcy, 33.775, 0.01);
  EXPECT_NEAR(equivalent_pore_diameter(h * h / 32, 1), h, 1e-18);
}

TEST(Flux, variation_is_relative_to_the_mean) {
  EXPECT_DOUBLE_EQ(flux_variation(std::vector<Real>{2, 2, 2}), 0);
  EXPECT_DOUBLE_EQ(flux_variation(std::vector<Real>{-1, -2, -3}), 1);
  EXPECT_TRUE(std::isnan(flux_variation(std::vector<Real>{0, 0})));
}

/// Pressure linear along eight layers of which the middle four are sample.
TEST(Window, leaves_reservoirs_out) {
  std::vector<Real> layers;
  for (int i = 0; i < 8; ++i) {
    layers.push_back(8 - (i + 0.5));
  }
  EXPECT_DOUBLE_EQ(window_pressure_drop(layers, {2, 6}, 100, -100), 4);
  EXPECT_DOUBLE_EQ(window_pressure_drop(layers, {0, 8}, 8, 0), 8);
  EXPECT_DOUBLE_EQ(face_pressure(layers, false), 8);
  EXPECT_DOUBLE_EQ(face_pressure(layers, true), 0);
  EXPECT_DOUBLE_EQ(face_pressure(std::vector<Real>{3}, true), 3);
}

/// k = L^3 / (6 pi a n K) says the same as G = F n / L^3 and F = 6 pi mu a K U.
TEST(Drag, agrees_with_permeability) {
  const Real a = 3e-4;
  const Real side = 1e-3;
  const Real mu = 1e-3;
  const Real gradient = 7;
  const Real k = 2e-8;
  const Real u = k * gradient / mu;
  const Real drag = mean_drag(gradient, side * side * side, 1);
  EXPECT_NEAR(side * side * side / (6 * std::numbers::pi * a * sphere_drag_factor(drag, mu, a, u)),
              k, 1e-18);
  EXPECT_DOUBLE_EQ(cylinder_drag_factor(6, 1, 2, 3), 1);
}

}  // namespace
}  // namespace porefines::analysis
