// SPDX-License-Identifier: MPL-2.0
// Forces on bodies in a flow with inertia.
#include <gtest/gtest.h>

#include "support/cylinder.hpp"

namespace porefines::test {

/// Two spheres of different size in a periodic box: what drives the fluid ends up on them.
TEST(InertialForces, add_up_to_the_drive) {
  const par::Communicator comm;
  const Real h = 1.0 / 20;
  flow::StokesSolver solver(comm, even_cut({20, 20, 20}, comm.size()), {h, h, h}, {}, 0.06);
  const Vec3 small{0.31, 0.27, 0.33};
  const Vec3 large{0.68, 0.71, 0.64};
  solver.set_surface(
      [&](const Vec3& x) { return std::min(norm(x - small) - 0.15, norm(x - large) - 0.22); });
  flow::InertialFlow flow(solver, 1.0, flow::Scheme::linear, flow::TimeScheme::euler, 1.0);
  flow::BodyForces forces(
      flow, solver,
      [&](const Vec3& x) { return norm(x - small) - 0.15 < norm(x - large) - 0.22 ? 0 : 1; }, 2);
  flow::Drive drive;
  drive.force = {1, 0, 0};
  const auto report = flow.settle(drive, {.tolerance = 1e-7}, 100);
  EXPECT_TRUE(report.converged);
  EXPECT_GT(solver.superficial_velocity().x * 0.44 / 0.06, 4);  // Re of the larger one
  const auto found = forces.sum(drive);
  flow.set_velocity([](const Vec3&) { return Vec3{1, 0, 0}; });
  const Real volume = 2 * flow.kinetic_energy();  // sum of W
  EXPECT_NEAR((found[0].x + found[1].x) / volume, 1, 2e-5);
  EXPECT_NEAR(found[0].y + found[1].y, 0, 2e-5 * volume);
  EXPECT_NEAR(found[0].z + found[1].z, 0, 2e-5 * volume);
  EXPECT_GT(found[1].x, found[0].x);
}

/// The thesis's domain (references.md A4), 8 cells per diameter; 12, 16 and 24: validation/inertia.
TEST(InertialForces, on_a_cylinder_at_re_10) {
  Cylinder cylinder(par::Communicator(), 8, 10, flow::Scheme::linear, flow::TimeScheme::euler);
  EXPECT_TRUE(cylinder.flow().settle(cylinder.drive(), {.tolerance = 1e-5}, 100).converged);
  const Vec3 c = cylinder.coefficients();
  EXPECT_NEAR(c.x / 2.981, 1, 0.005);
  EXPECT_NEAR(c.y, 0, 1e-3);
}

/// A step of a smooth flow costs about one cycle: the guess is a parabola in time. A line needed 1.4 cycles.
TEST(InertialForces, steps_past_a_cylinder_cost_one_cycle) {
  Cylinder cylinder(par::Communicator(), 8, 100, flow::Scheme::lust, flow::TimeScheme::bdf2);
  int cycles = 0;
  for (int s = 0; s < 60; ++s) {
    const auto report = cylinder.flow().advance(0.4 / 8, cylinder.drive(), {.tolerance = 1e-6});
    EXPECT_TRUE(report.converged);
    cycles += s < 30 ? 0 : report.cycles;
  }
  EXPECT_LE(cycles, 36);
}

}  // namespace porefines::test
