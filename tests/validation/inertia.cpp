// SPDX-License-Identifier: MPL-2.0
// Long runs with inertia: half an hour in all on one core.
#include <gtest/gtest.h>

#include "analysis/shedding.hpp"
#include "support/cavity.hpp"
#include "support/cylinder.hpp"

namespace porefines::test {

namespace {

struct Reference {
  Real reynolds, drag, wake;
};

}  // namespace

/// The thesis's domain, references.md A4; 24 cells per diameter.
TEST(InertiaValidation, steady_cylinder) {
  for (const Reference& q : {Reference{10, 2.981, 0.261}, {40, 1.587, 2.275}}) {
    Cylinder cylinder(par::Communicator(), 24, q.reynolds, flow::Scheme::linear,
                      flow::TimeScheme::euler);
    EXPECT_TRUE(cylinder.flow()
                    .settle(cylinder.drive(), {.tolerance = 1e-6, .max_cycles = 60}, 1000)
                    .converged);
    EXPECT_NEAR(cylinder.coefficients().x / q.drag, 1, 0.01) << q.reynolds;
    EXPECT_NEAR(cylinder.wake() / q.wake, 1, 0.03) << q.reynolds;
  }
}

/// Mean C_d 1.33 to 1.40, Strouhal number 0.160 to 0.170; their change from 8 to 12 cells per diameter.
TEST(InertiaValidation, vortices_behind_a_cylinder) {
  for (const int cells : {8, 12}) {
    Cylinder cylinder(par::Communicator(), cells, 100, flow::Scheme::linear,
                      flow::TimeScheme::bdf2);
    cylinder.flow().set_velocity([](const Vec3& x) {
      return Vec3{1, 0.2 * std::exp(-std::pow(x.x - 13, 2) - std::pow(x.y - 12.5, 2)), 0};
    });
    std::vector<Real> time;
    std::vector<Real> drag;
    std::vector<Real> lift;
    Real step = 0.4 / cells;
    while (cylinder.flow().time() < 140) {
      ASSERT_TRUE(cylinder.flow().advance(step, cylinder.drive(), {.tolerance = 1e-6}).converged);
      const Real courant = cylinder.flow().crossing_rate() * step;
      step *= courant < 0.7 || courant > 0.9 ? 0.85 / courant : 1;
      const Vec3 c = cylinder.coefficients();
      time.push_back(cylinder.flow().time());
      drag.push_back(c.x);
      lift.push_back(c.y);
    }
    const analysis::Shedding found = analysis::find_shedding(time, drag, lift);
    std::printf("%d cells: C_d %.4f, C_l %.4f, St %.4f\n", cells, found.drag, found.lift,
                found.frequency);
    EXPECT_GT(found.drag, 1.33);
    EXPECT_LT(found.drag, 1.40);
    EXPECT_GT(found.frequency, 0.160);
    EXPECT_LT(found.frequency, 0.170);
  }
}

/// Ghia, Ghia & Shin (1982) print -0.38289, -0.51550, 0.37095 from 129^2 points; Botella & Peyret (1998), spectral,
/// -0.38857, -0.52708, 0.37694.
TEST(InertiaValidation, cavity_at_re_1000) {
  const Extrema e = cavity(128, 1000);
  EXPECT_NEAR(e.u_min / -0.38289, 1, 0.01);
  EXPECT_NEAR(e.v_max / 0.37095, 1, 0.01);
  EXPECT_NEAR(e.v_min / -0.52708, 1, 0.015);
}

}  // namespace porefines::test
