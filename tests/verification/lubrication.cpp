// SPDX-License-Identifier: MPL-2.0
// Narrow gaps, where the grid alone saturates: references.md B1, B2, B4, B5.
#include <array>
#include <tuple>

#include <gtest/gtest.h>

#include "mobility/known.hpp"

namespace porefines::mobility {

TEST(Lubrication, sphere_towards_a_wall) {
  for (const auto& [height, exact] : {std::pair{3.7621957, 1.4128741},
                                      {2.3524096, 1.8374748},
                                      {1.5430806, 3.0360645},
                                      {1.127626, 9.2517628},
                                      {1.0453, 23.679391}}) {
    for (const int size : {6, 8}) {
      const Real found = wall_factor(size, height);
      std::printf("[ measured ] h/a = %.4f, D = %d: %.4f, %+.2f %%\n", height, size, found,
                  100 * (found / exact - 1));
      const Real gap = (height - 1) * size / 2;
      EXPECT_NEAR(found / exact, 1, gap >= 1 ? 0.01 : 0.02)
          << "h/a = " << height << ", D = " << size;
    }
  }
}

/// h/a = 1.5431: a gap of 1.6 cells. D = 8 gives +0.3, +0.1, +0.7, -0.1 and +0.5 %.
TEST(Lubrication, sphere_along_a_wall_and_in_shear) {
  const AlongWall found = along_wall(6, 1.5431);
  struct Known {
    const char* name;
    Real found;
    Real exact;
    Real most;
  };
  for (const Known& known : {Known{"drag along the wall", found.drag, 1.5673, 0.01},
                             {"force in shear", found.force, 1.4393, 0.01},
                             {"torque in shear", found.torque, 0.9738, 0.03},
                             {"free speed", found.speed, 0.9220, 0.01},
                             {"free spin", found.spin, 0.9238, 0.02}}) {
    const Real ratio = known.found / known.exact;
    std::printf("[ measured ] %s: %+.2f %%\n", known.name, 100 * (ratio - 1));
    EXPECT_NEAR(ratio, 1, known.most) << known.name;
  }
}

/// Approaching: the mean over directions and places against the grid.
TEST(Lubrication, two_spheres_on_their_line_of_centres) {
  for (const auto& [distance, exact, scatter] :
       {std::tuple{4.0, 1.59668, 0.01}, {2.5, 2.77242, 0.02}, {2.05, 12.71129, 0.3}}) {
    const Approach found = approach(6, distance, exact);
    std::printf("[ measured ] r/a = %.2f: mean %+.2f %%, worst %.1f %%\n", distance,
                100 * (found.mean - 1), 100 * found.worst);
    EXPECT_NEAR(found.mean, 1, distance > 2.4 ? 0.01 : 0.02) << "r/a = " << distance;
    EXPECT_LT(found.worst, scatter) << "r/a = " << distance;
  }
}

TEST(Lubrication, two_spheres_that_go_together) {
  for (const auto& [distance, exact] :
       {std::pair{4.0, 0.742258}, {2.5, 0.672916}, {2.05, 0.648034}}) {
    const Real found = together(6, distance);
    std::printf("[ measured ] r/a = %.2f: %.4f, %+.2f %%\n", distance, found,
                100 * (found / exact - 1));
    EXPECT_NEAR(found / exact, 1, 0.01) << "r/a = " << distance;
  }
}

TEST(Lubrication, free_sphere_on_the_axis_of_a_tube) {
  for (const auto& [ratio, exact] : {std::pair{0.3, 0.94049}, {0.5, 0.83996}}) {
    EXPECT_NEAR(tube_speed(8, ratio) / exact, 1, 0.02) << "a/R = " << ratio;
  }
}

}  // namespace porefines::mobility
