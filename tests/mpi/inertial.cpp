// SPDX-License-Identifier: MPL-2.0
// Flow with inertia does not depend on the number of ranks.
#include <gtest/gtest.h>

#include "flow/inertial_flow.hpp"
#include "support/free_spheres.hpp"

namespace porefines::test {

namespace {

struct State {
  Real energy;
  Real rate;  ///< crossing rate
  std::vector<Real> plane;
};

/// A stream past a sphere, into the open; LUST, which looks two cells far.
State stream(const par::Communicator& comm, flow::TimeScheme time) {
  Boundaries b;
  b.kind = {FaceKind::velocity, FaceKind::outflow,  FaceKind::slip,
            FaceKind::wall,     FaceKind::periodic, FaceKind::periodic};
  flow::StokesSolver solver(comm, even_cut({40, 24, 24}, comm.size()), {0.1, 0.1, 0.1}, b, 0.01);
  solver.set_surface([](const Vec3& x) { return norm(x - Vec3{1.31, 1.17, 1.23}) - 0.5; });
  flow::InertialFlow flow(solver, 1.0, flow::Scheme::lust, time, 1.0);
  flow::Drive drive;
  drive.face_value[0] = 1;
  for (int s = 0; s < 4; ++s) {
    EXPECT_TRUE(flow.advance(0.05, drive, {.tolerance = 1e-7}).converged);
  }
  return {flow.kinetic_energy(), flow.crossing_rate(), solver.plane_velocities(0, 20)};
}

/// Speed of a heavy sphere that falls across the seams of a periodic box.
Vec3 falling(const par::Communicator& comm) {
  flow::StokesSolver solver(comm, even_cut({16, 16, 36}, comm.size()), {1, 1, 1}, {}, 0.2);
  solver.set_surface([](const Vec3&) { return 1e3; });
  flow::InertialFlow flow(solver, 1.0, flow::Scheme::lust, flow::TimeScheme::bdf2, 1.0);
  flow::Drive drive;
  drive.force = {0, 0, 0.01};
  flow::Sphere ball = sphere(1, {8.2, 7.7, 19.9}, 3);
  ball.density = 2;
  ball.velocity = ball.velocity_before = {0.1, 0, -0.5};
  ball.force = {0, 0, -10};
  for (int s = 0; s < 3; ++s) {
    ball.position += ball.velocity * 0.6;
    const auto here = mine(solver, {ball});
    flow.set_spheres(here);
    EXPECT_TRUE(flow.advance(0.6, drive, {.tolerance = 1e-6}).converged);
    const Vec3 v = here.empty() ? Vec3{} : flow.sphere_motions()[0].velocity;
    ball.velocity_before = ball.velocity;
    ball.velocity = {comm.sum(v.x), comm.sum(v.y), comm.sum(v.z)};
  }
  return ball.velocity;
}

}  // namespace

TEST(InertialRanks, one_is_all) {
  const State alone = stream(par::Communicator::self(), flow::TimeScheme::bdf2);
  const State together = stream(par::Communicator(), flow::TimeScheme::bdf2);
  EXPECT_NEAR(together.energy / alone.energy, 1, 1e-6);
  EXPECT_NEAR(together.rate / alone.rate, 1, 1e-5);
  for (std::size_t i = 0; i < alone.plane.size(); ++i) {
    EXPECT_NEAR(together.plane[i], alone.plane[i], 1e-5);
  }
}

TEST(InertialRanks, a_sphere_crosses_seams) {
  const Vec3 alone = falling(par::Communicator::self());
  const Vec3 together = falling(par::Communicator());
  EXPECT_LT(alone.z, -0.1);
  for (int a = 0; a < 3; ++a) {
    EXPECT_NEAR(together[a], alone[a], 1e-5) << a;
  }
}

TEST(InertialRanks, same_number_same_bits) {
  const State first = stream(par::Communicator(), flow::TimeScheme::midpoint);
  const State second = stream(par::Communicator(), flow::TimeScheme::midpoint);
  EXPECT_EQ(first.energy, second.energy);
  EXPECT_EQ(first.plane, second.plane);
}

}  // namespace porefines::test
