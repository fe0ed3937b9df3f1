// SPDX-License-Identifier: MPL-2.0
// The first effect of inertia in a periodic array.
#include "analysis/forchheimer.hpp"

#include <gtest/gtest.h>

#include "flow/inertial_flow.hpp"
#include "support/solve.hpp"

namespace porefines::test {

/// Square array of cylinders, 20 % solid: k from F/(mu U) = 51.527 (Sangani & Acrivos 1982), and the first correction
/// to Darcy's law is cubic in U (Mei & Auriault 1991): a linear one would make the exponent 1.
TEST(ForchheimerSweep, darcy_and_the_cubic_law_of_a_square_array) {
  constexpr int n = 24;
  const Real radius = std::sqrt(0.2 / std::numbers::pi);
  const par::Communicator comm;
  flow::StokesSolver solver(comm, even_cut({n, n, 1}, comm.size()), {1.0 / n, 1.0 / n, 1.0 / n}, {},
                            1.0);
  solver.set_surface([&](const Vec3& x) { return std::hypot(x.x - 0.5, x.y - 0.5) - radius; });
  flow::InertialFlow flow(solver, 1.0, flow::Scheme::linear, flow::TimeScheme::euler, 10);
  std::vector<analysis::SweepPoint> points;
  for (const Real gradient : {50.0, 100.0, 170.0, 260.0}) {
    const auto report = flow.settle({.force = {gradient, 0, 0}}, {.tolerance = 1e-6}, 60);
    EXPECT_TRUE(report.converged) << gradient;
    EXPECT_LE(report.cycles, 120) << gradient;
    points.push_back({solver.superficial_velocity().x, gradient});
  }
  const auto fit = analysis::fit_inertia(points, {1, 1});
  std::printf("[ measured ] k %.5f of the exact one, exponent %.3f\n",
              fit.permeability.value * 51.527, fit.exponent.value);
  EXPECT_EQ(fit.slow, 4);
  EXPECT_NEAR(fit.permeability.value * 51.527, 1, 0.005);
  EXPECT_NEAR(fit.exponent.value, 2, 0.1);
}

}  // namespace porefines::test
