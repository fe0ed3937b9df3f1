// SPDX-License-Identifier: MPL-2.0
// Spheres that move in a flow with inertia.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "flow/inertial_flow.hpp"
#include "support/free_spheres.hpp"

namespace porefines::test {

namespace {

/// Drag over time of a sphere of diameter 8 in a periodic box of 32 cells, Re 20: the sphere stands in a
/// stream that starts at once, or starts itself in fluid at rest.
std::vector<Real> drag(bool sphere_moves, int steps, Real step) {
  constexpr Real speed = 1;
  const par::Communicator comm;
  flow::StokesSolver solver(comm, even_cut({32, 32, 32}, comm.size()), {1, 1, 1}, {}, 8.0 / 20);
  solver.set_surface([](const Vec3&) { return 1e3; });
  flow::InertialFlow flow(solver, 1.0, flow::Scheme::linear, flow::TimeScheme::bdf2, speed);
  if (!sphere_moves) {
    flow.set_velocity([](const Vec3&) { return Vec3{-speed, 0, 0}; });
  }
  flow::Sphere q = sphere(1, {10.13, 16.27, 16.41}, 4);
  q.held = true;
  q.velocity = {sphere_moves ? speed : 0, 0, 0};
  std::vector<Real> out;
  for (int s = 0; s < steps; ++s) {
    q.position += q.velocity * step;
    flow.set_spheres(mine(solver, {q}));
    EXPECT_TRUE(flow.advance(step, {}, {.tolerance = 1e-5}).converged);
    out.push_back(flow.sphere_motions().empty() ? 0 : comm.sum(flow.sphere_motions()[0].force.x));
  }
  return out;
}

}  // namespace

/// A pair of moments of two frames: their drags differ by 1 % in the mean over the cells that the moving
/// one crosses, by 2.5 % at most at single places, where cells are covered (docs/theory-inertia.md).
TEST(InertialSpheres, galilean_pair_at_re_20) {
  const auto stands = drag(false, 24, 0.25);
  const auto moves = drag(true, 24, 0.25);
  Real mean = 0;
  for (std::size_t s = 8; s < stands.size(); ++s) {
    EXPECT_NEAR(moves[s] / stands[s], 1, 0.025) << s;
    mean += moves[s] / stands[s] / 16;
  }
  EXPECT_NEAR(mean, 1, 0.01);
}

/// Nothing gives a pressure in a periodic box. Its mean once doubled every 15 steps of a sphere that crosses
/// cells, by cells just uncovered whose guess was twice their pressure, until no solve converged.
TEST(InertialSpheres, pressure_of_a_periodic_box_stays_level) {
  const par::Communicator comm;
  const Int3 cells{12, 12, 12};
  flow::StokesSolver solver(comm, even_cut(cells, comm.size()), {1, 1, 1}, {}, 8.0 / 20);
  solver.set_surface([](const Vec3&) { return 1e3; });
  flow::InertialFlow flow(solver, 1.0, flow::Scheme::linear, flow::TimeScheme::bdf2, 1);
  flow::Sphere q = sphere(1, {0.1, 6.2, 6.3}, 3);
  q.held = true;
  q.velocity = {1, 0, 0};
  int early = 0;
  int late = 0;
  for (int s = 0; s < 80; ++s) {
    q.position.x = std::fmod(q.position.x + 0.5, 12);
    flow.set_spheres(mine(solver, {q}));
    const auto report = flow.advance(0.5, {}, {.tolerance = 1e-4});
    ASSERT_TRUE(report.converged);
    (s < 40 ? early : late) += report.cycles;
  }
  const std::vector<Real> p = solver.layer_pressures(0);
  const auto [least, most] = std::minmax_element(p.begin(), p.end());
  Real mean = 0;
  for (const Real layer : p) {
    mean += layer / 12;
  }
  EXPECT_LT(std::abs(mean), 0.2 * (*most - *least));
  EXPECT_LE(late, early);
}

}  // namespace porefines::test
