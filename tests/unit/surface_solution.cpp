// SPDX-License-Identifier: MPL-2.0
// Printed digits: references.md D.
#include <gtest/gtest.h>

#include "surface/solution.hpp"

namespace porefines::surface {
namespace {

Solution at_25_degrees(Real ionic_strength) {
  return {298.15, 78.4, ionic_strength};
}

TEST(SurfaceSolution, thermal_energy_and_voltage) {
  EXPECT_NEAR(thermal_energy(298.15), 4.11640e-21, 0.5e-26);
  EXPECT_NEAR(thermal_energy(298.15) / elementary_charge, 25.6926e-3, 0.5e-7);
}

TEST(SurfaceSolution, debye_length) {
  EXPECT_NEAR(debye_length(at_25_degrees(0.1)), 30.401e-9, 0.5e-12);
  EXPECT_NEAR(debye_length(at_25_degrees(1)), 9.6137e-9, 0.5e-13);
  EXPECT_NEAR(debye_length(at_25_degrees(10)), 3.0401e-9, 0.5e-13);
  EXPECT_NEAR(debye_length(at_25_degrees(100)), 0.961370e-9, 0.5e-15)
      << "printed 0.96138, but 30.4012/sqrt(1000) = 0.96137";
}

TEST(SurfaceSolution, diffusivity) {
  EXPECT_NEAR(diffusivity(298.15, 0.8903e-3, 1e-6), 4.9058e-13, 0.5e-17);
  EXPECT_NEAR(diffusivity(298.15, 0.8903e-3, 5e-6), 9.8116e-14, 0.5e-18);
}

}  // namespace
}  // namespace porefines::surface
