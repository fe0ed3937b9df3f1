// SPDX-License-Identifier: MPL-2.0
// Sliding, rolling and partial slip against closed forms.
#include <gtest/gtest.h>

#include "support/spheres.hpp"

namespace porefines::test {

namespace {

using dem::Body;
using dem::Settings;
using dem::System;

constexpr Real radius = 0.01;
constexpr Real density = 2500;
constexpr Real g = 9.81;
/// Stiff enough for the weight to press it in by 1e-5 of its radius, soft enough for large steps.
const dem::Elastic ball{"ball", 2e7, 0.3};
constexpr Real dt = 2e-6;

/// A ball at rest on a plane through the origin, gravity at an angle to its normal; wide space.
System on_slope(Real angle, const dem::Friction& friction, const dem::ContactModel& model = {}) {
  Settings s = cube(10, false, ball, friction);
  s.gravity = {g * std::sin(angle), 0, -g * std::cos(angle)};
  s.walls.emplace_back(dem::Primitives{dem::Plane{{0, 0, 0}, {0, 0, 1}}});
  s.model = model;
  System system(par::Communicator::self(), s);
  const Real weight = density * 4.0 / 3 * std::numbers::pi * radius * radius * radius * g;
  const Real modulus = s.materials.pair(0, 0).modulus;
  const Real overlap =
      std::pow(0.75 * weight * std::cos(angle) / (modulus * std::sqrt(radius)), 2.0 / 3);
  Body b = sphere(1, {1, 5, radius - overlap}, radius, density);
  system.insert(std::vector<Body>{b});
  return system;
}

}  // namespace

TEST(Friction, rolls_down_an_incline_without_sliding) {
  const Real angle = 0.3;  // tan = 0.31 < 3.5 mu
  System system = on_slope(angle, {0.5, 0.5});
  const Real time = 0.1;
  system.advance(dt, std::llround(time / dt));
  const auto& p = system.particles();
  EXPECT_NEAR(p.velocity[0].x / (5.0 / 7 * g * std::sin(angle) * time), 1, 5e-3);
  EXPECT_NEAR(p.angular_velocity[0].y * radius / p.velocity[0].x, 1, 5e-3);
}

TEST(Friction, slides_down_a_steep_incline) {
  const Real mu = 0.1;
  const Real angle = 0.6;  // tan = 0.68 > 3.5 mu
  System system = on_slope(angle, {0.5, mu});
  const Real time = 0.1;
  system.advance(dt, std::llround(time / dt));
  const auto& p = system.particles();
  const Real push = g * (std::sin(angle) - mu * std::cos(angle));
  EXPECT_NEAR(p.velocity[0].x / (push * time), 1, 5e-3);
  EXPECT_NEAR(p.angular_velocity[0].y / (2.5 * mu * g * std::cos(angle) / radius * time), 1, 5e-3);
}

TEST(Friction, the_limit_between_rolling_and_sliding) {
  const Real mu = 0.2;
  for (const Real factor : {0.99, 1.01}) {
    const Real angle = std::atan(3.5 * mu * factor);
    System system = on_slope(angle, {0.5, mu});
    const auto& p = system.particles();
    const auto slip = [&p] { return p.velocity[0].x - radius * p.angular_velocity[0].y; };
    system.advance(dt, 25000);  // the shear spring has settled
    const Real before = slip();
    system.advance(dt, 25000);
    const Real time = 25000 * dt;
    const Real grows = factor < 1 ? 0 : time * g * (std::sin(angle) - 3.5 * mu * std::cos(angle));
    EXPECT_NEAR(slip() - before, grows, 1e-3 * g * std::sin(angle) * time) << factor;
  }
}

TEST(Friction, sliding_turns_into_rolling) {
  const Real mu = 0.3;
  const Real v0 = 0.3;
  System system = on_slope(0, {0.5, mu});
  system.particles().velocity[0].x = v0;
  const Real rolling_at = 2 * v0 / (7 * mu * g);
  // Just before and just after the end of sliding.
  const Index before = std::llround(0.99 * rolling_at / dt);
  system.advance(dt, before);
  const auto& p = system.particles();
  EXPECT_NEAR(p.velocity[0].x / (v0 - mu * g * 0.99 * rolling_at), 1, 5e-3);
  EXPECT_GT(p.velocity[0].x - radius * p.angular_velocity[0].y, 0.005 * v0);
  system.advance(dt, std::llround(0.5 * rolling_at / dt));
  EXPECT_NEAR(p.velocity[0].x / (5.0 / 7 * v0), 1, 5e-3);
  EXPECT_NEAR(p.angular_velocity[0].y * radius / (5.0 / 7 * v0), 1, 5e-3);
}

TEST(Friction, constant_torque_slows_a_rolling_ball) {
  // a = -(5/7) mu_r g; it stops and stays.
  const Real mu_r = 0.02;
  const Real v0 = 0.02;
  dem::ContactModel model;
  model.rolling = dem::ConstantTorque{};
  System system = on_slope(0, {0.5, 0.5, mu_r}, model);
  auto& p = system.particles();
  p.velocity[0].x = v0;
  p.angular_velocity[0].y = v0 / radius;
  const Real deceleration = 5.0 / 7 * mu_r * g;
  const Real time = 0.5 * v0 / deceleration;
  system.advance(dt, std::llround(time / dt));
  EXPECT_NEAR(p.velocity[0].x / (v0 - deceleration * time), 1, 5e-3);
  system.advance(dt, std::llround(2 * time / dt));
  EXPECT_NEAR(p.velocity[0].x, 0, 1e-3 * v0);
}

TEST(Friction, rolling_spring_holds_on_a_gentle_slope_and_gives_on_a_steeper_one) {
  // It rolls when tan(angle) > mu_r.
  const Real mu_r = 0.05;
  dem::ContactModel model;
  model.rolling = dem::RollingSpring{};
  System holds = on_slope(std::atan(0.8 * mu_r), {0.5, 0.5, mu_r, 0.5}, model);
  holds.advance(dt, 250000);
  EXPECT_LT(std::abs(holds.particles().velocity[0].x), 1e-6);
  const Real angle = std::atan(2 * mu_r);
  System rolls = on_slope(angle, {0.5, 0.5, mu_r, 0.5}, model);
  rolls.advance(dt, 50000);
  const Real before = rolls.particles().velocity[0].x;
  rolls.advance(dt, 50000);
  const Real push = 5.0 / 7 * g * (std::sin(angle) - mu_r * std::cos(angle));
  EXPECT_NEAR((rolls.particles().velocity[0].x - before) / (push * 50000 * dt), 1, 5e-3);
}

}  // namespace porefines::test
