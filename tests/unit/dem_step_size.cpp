// SPDX-License-Identifier: MPL-2.0
#include <gtest/gtest.h>

#include "dem/step_size.hpp"
#include "support/spheres.hpp"

namespace porefines::dem {

TEST(DemStepSize, integrator_follows_the_stokes_number) {
  // 5 um latex at 1 mm/s in water creeps; a grain of sand that falls through it does not.
  EXPECT_EQ(integrator_for(stokes_number(1050, 2.5e-6, 1e-3, 1e-3)), Integrator::overdamped);
  EXPECT_EQ(integrator_for(stokes_number(2650, 0.5e-3, 0.1, 1e-3)), Integrator::newton_euler);
  EXPECT_EQ(integrator_for(stokes_number(2650, 0.5e-3, 0.1, 0)), Integrator::newton_euler) << "dry";
}

TEST(DemStepSize, the_step_follows_the_speed) {
  constexpr Real d = 1e-3;
  System system(par::Communicator::self(), test::cube(10 * d, false, {"ball", 1e7, 0.3}, {0.5, 0}));
  std::vector bodies{test::sphere(1, {3 * d, 5 * d, 5 * d}, d / 2, 2500),
                     test::sphere(2, {6 * d, 5 * d, 5 * d}, d / 4, 2500)};
  bodies[0].velocity.x = 0.01;
  system.insert(bodies);
  const auto step = [&](Real acceleration) {
    return longest_step(system, {30, d / 4, acceleration, system.top_speed()});
  };
  const Real slow = step(0);
  EXPECT_NEAR(slow * 30, system.contact_duration(0.02), 1e-12);
  system.particles().velocity[0].x = 0.32;
  EXPECT_NEAR(step(0) / slow, 0.5, 1e-9) << "Hertz: duration ~ speed^(-1/5)";
  system.particles().velocity[0] = {};
  EXPECT_NEAR(step(9.81) * 30, system.contact_duration(std::sqrt(2 * 9.81 * d / 4)), 1e-12)
      << "at rest: a fall through a radius is to come";
  system.particles().velocity[0].x = 1e6;
  EXPECT_LE(step(0) * 1e6, d / 4 / 20 * (1 + 1e-12)) << "never past anything";
}

}  // namespace porefines::dem
