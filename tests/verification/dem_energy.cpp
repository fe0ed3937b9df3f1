// SPDX-License-Identifier: MPL-2.0
// What contacts dissipate, added up step by step, is what the energy lacks: by mechanism in cases with
// a closed form, in all where everything happens at once.
#include <gtest/gtest.h>

#include "support/spheres.hpp"

namespace porefines::test {
namespace {

using dem::Settings;
using dem::System;
using dem::Totals;

constexpr Real d = 5e-6;

Real energy(const Totals& t) {
  return t.kinetic + t.rotational + t.elastic + t.potential;
}

TEST(DemEnergy, a_damped_impact_dissipates_what_its_restitution_says) {
  for (const Real restitution : {0.3, 0.8}) {
    Settings s = cube(20 * d, false, latex, {restitution, 0.0});
    s.account = true;
    System system(par::Communicator::self(), s);
    std::vector bodies{sphere(1, {9 * d, 10 * d, 10 * d}, d / 2, 1050),
                       sphere(2, {10.01 * d, 10 * d, 10 * d}, d / 2, 1050)};
    bodies[0].velocity.x = 0.1;
    system.insert(bodies);
    system.advance(2e-9, 4000);
    const Real mass = system.particles().mass[0] / 2;
    const Real exact = 0.5 * mass * 0.01 * (1 - restitution * restitution);
    const Totals t = system.totals();
    EXPECT_EQ(t.contacts, 0);
    EXPECT_NEAR(t.dissipated.normal / exact, 1, 5e-3);
    EXPECT_LT(std::abs(t.dissipated.sliding + t.dissipated.rolling), 1e-12 * exact);
  }
}

TEST(DemEnergy, a_sphere_thrown_onto_a_floor_rubs_two_sevenths_away) {
  Settings s = cube(100 * d, false, latex, {0.3, 0.4});
  s.walls.emplace_back(dem::Primitives{dem::Plane{{0, 0, 0}, {0, 0, 1}}});
  s.gravity = {0, 0, -1000};
  s.account = true;
  System system(par::Communicator::self(), s);
  std::vector bodies{sphere(1, {50 * d, 50 * d, d / 2 - 1e-5 * d}, d / 2, 1050)};
  system.insert(bodies);
  system.advance(1e-8, 20000);  // comes to rest
  system.particles().velocity[0].x = 0.05;
  const Totals before = system.totals();
  system.advance(1e-8, 20000);
  const Totals after = system.totals();
  const Real exact = 2.0 / 7 * 0.5 * system.particles().mass[0] * 0.05 * 0.05;
  EXPECT_NEAR(system.particles().velocity[0].x, 0.05 * 5 / 7, 1e-4 * 0.05) << "rolls";
  EXPECT_NEAR((after.dissipated.sliding - before.dissipated.sliding) / exact, 1, 5e-3);
}

TEST(DemEnergy, the_balance_of_a_colliding_crowd_closes) {
  using Rolling = decltype(dem::ContactModel::rolling);
  for (const auto& rolling : {Rolling{dem::ConstantTorque{}}, Rolling{dem::RollingSpring{}}}) {
    Real error[2];
    for (const int finer : {0, 1}) {
      Settings s = cube(8.6 * d, false, latex, {0.7, 0.5, 0.1, 0.3});
      s.walls.emplace_back(
          dem::box_faces(s.box.low, s.box.high, {true, true, true, true, true, true}));
      s.model.rolling = rolling;
      s.gravity = {0, 0, -1000};
      s.account = true;
      System system(par::Communicator::self(), s);
      system.insert(gas(8, 8.6 * d, d / 2, 1.2, 0.1, 3));
      const Real before = energy(system.totals());
      system.advance(finer == 0 ? 1e-8 : 5e-9, finer == 0 ? 3000 : 6000);
      const Totals t = system.totals();
      const Real lost = before - energy(t);
      EXPECT_GT(lost, 0.15 * before);
      EXPECT_GT(t.dissipated.normal, 0.02 * lost);
      EXPECT_GT(t.dissipated.sliding, 0.02 * lost);
      EXPECT_GT(t.dissipated.rolling, 0.02 * lost);
      const Real sum = t.dissipated.normal + t.dissipated.sliding + t.dissipated.rolling;
      error[finer] = std::abs(sum - lost) / lost;
    }
    EXPECT_LT(error[0], 1e-3);
    EXPECT_LT(error[1], 0.6 * error[0]) << "the error of the steps: first order";
  }
}

}  // namespace
}  // namespace porefines::test
