// SPDX-License-Identifier: MPL-2.0
// Chung & Ooi, Granular Matter 13 (2011) 643: benchmark tests 1 to 4. Values: exact Hertz theory.
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "support/spheres.hpp"

namespace porefines::test {

namespace {

using dem::Body;
using dem::Settings;
using dem::System;

constexpr Real pi = std::numbers::pi;

/// What one impact shows.
struct Impact {
  Real largest_overlap = 0;  ///< [m]
  Real largest_force = 0;    ///< [N]
  Real duration = 0;         ///< [s] from the first to the last touch, to one step
  Body after;                ///< particle 1 once apart
};

/// Runs until particle 1 has touched and parted; steps of a fraction of the contact's duration.
Impact collide(System& system, Real dt) {
  Impact out;
  bool touched = false;
  for (int step = 0; step < 1000000; ++step) {
    system.advance(dt, 1);
    const auto& p = system.particles();
    const std::size_t i = find(p, 1);
    const auto contacts = system.contacts();
    if (!contacts.empty()) {
      touched = true;
      out.duration += dt;
      out.largest_overlap = std::max(out.largest_overlap, contacts[0].overlap);
      out.largest_force = std::max(out.largest_force, norm(p.force[i]));
    } else if (touched) {
      out.after.velocity = p.velocity[i];
      out.after.angular_velocity = p.angular_velocity[i];
      return out;
    }
  }
  ADD_FAILURE() << "no impact";
  return out;
}

/// Two equal spheres that meet head on.
Impact head_on(const dem::Elastic& e, Real density, Real radius, Real speed, Real restitution,
               const dem::ContactModel& model, Real dt) {
  Settings s = cube(20 * radius, false, e, {restitution, 0.35});
  s.model = model;
  System system(par::Communicator::self(), s);
  Body a = sphere(1, {9 * radius, 10 * radius, 10 * radius}, radius, density);
  Body b = sphere(2, {11.0001 * radius, 10 * radius, 10 * radius}, radius, density);
  a.velocity.x = speed, b.velocity.x = -speed;
  system.insert(std::vector<Body>{a, b});
  return collide(system, dt);
}

/// A sphere that falls on the plane z = 0 without gravity. The plane is rigid unless given.
Impact on_plane(const dem::Elastic& e, const dem::Elastic& plane, Real density, Real radius,
                const Vec3& velocity, const dem::Friction& friction, Real dt) {
  Settings s = cube(20 * radius, false, e, friction);
  s.materials = dem::MaterialTable({e, plane}, friction);
  s.walls.emplace_back(dem::Primitives{dem::Plane{{0, 0, 0}, {0, 0, 1}}});
  s.wall_species = {1};
  System system(par::Communicator::self(), s);
  Body a = sphere(1, {10 * radius, 10 * radius, 1.0001 * radius}, radius, density);
  a.velocity = velocity;
  system.insert(std::vector<Body>{a});
  return collide(system, dt);
}

const dem::Elastic rigid{"rigid", 1e20, 0.3};

}  // namespace

TEST(Impact, chung_ooi_1_two_spheres) {
  const Impact glass = head_on({"glass", 48e9, 0.20}, 2800, 0.010, 10, 1, {}, 40e-6 / 400);
  EXPECT_NEAR(glass.largest_overlap / 274.1127e-6, 1, 5e-3);
  EXPECT_NEAR(glass.largest_force / 10.69689e3, 1, 5e-3);
  EXPECT_NEAR(glass.duration / 40.3395e-6, 1, 5e-3);
  const Impact limestone = head_on({"limestone", 20e9, 0.25}, 2500, 0.010, 10, 1, {}, 56e-6 / 400);
  const Real m = 2500 * 4.0 / 3 * pi * 1e-6 / 2;
  const Real modulus = 20e9 / (2 * (1 - 0.0625));
  const Real overlap = std::pow(15 * m * 400 / (16 * modulus * std::sqrt(0.005)), 0.4);
  EXPECT_NEAR(limestone.largest_overlap / overlap, 1, 5e-3);
  EXPECT_NEAR(limestone.duration / (2.9432752 * overlap / 20), 1, 5e-3);
}

TEST(Impact, chung_ooi_2_sphere_on_a_rigid_plane) {
  const Impact a =
      on_plane({"aluminium", 70e9, 0.30}, rigid, 2699, 0.1, {0, 0, -0.2}, {1, 0}, 731.657e-6 / 400);
  EXPECT_NEAR(a.largest_overlap / 49.7172e-6, 1, 5e-3);
  EXPECT_NEAR(a.largest_force / 11.36986e3, 1, 5e-3);
  EXPECT_NEAR(a.duration / 731.657e-6, 1, 5e-3);
}

TEST(Impact, chung_ooi_3_restitution) {
  for (const Real e : {0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0}) {
    for (const Real speed : {0.02, 2.0}) {
      const dem::Elastic oxide{"aluminium oxide", 380e9, 0.23};
      const Real dt = 2e-5 * std::pow(speed, -0.2) / 2000;
      const Impact plane = on_plane(oxide, rigid, 4000, 2.5e-3, {0, 0, -speed}, {e, 0}, dt);
      EXPECT_NEAR(plane.after.velocity.z / (e * speed), 1, 5e-3) << e << " at " << speed;
      const Impact pair = head_on(oxide, 4000, 2.5e-3, speed, e, {}, dt);
      EXPECT_NEAR(-pair.after.velocity.x / (e * speed), 1, 5e-3) << e << " at " << speed;
    }
  }
}

TEST(Impact, restitution_of_the_linear_spring) {
  for (const Real e : {0.2, 0.5, 0.9, 1.0}) {
    dem::ContactModel model;
    model.normal = dem::LinearSpring{1e6};
    const Real m = 4000 * 4.0 / 3 * pi * std::pow(2.5e-3, 3) / 2;
    const Real zeta = -std::log(e) / std::hypot(std::log(e), pi);
    const Real duration = pi / std::sqrt(1e6 / m * (1 - zeta * zeta));
    const Impact pair = head_on({"any", 1e9, 0.3}, 4000, 2.5e-3, 0.5, e, model, duration / 1000);
    EXPECT_NEAR(-pair.after.velocity.x / (e * 0.5), 1, 5e-3) << e;
    EXPECT_NEAR(pair.duration / duration, 1, 5e-3) << e;
  }
}

TEST(Impact, cutting_the_pull_raises_the_restitution) {
  // Why it is not the default: the requested 0.50 becomes 0.55.
  dem::ContactModel model;
  model.normal = dem::Hertz{true};
  const Impact pair = head_on({"glass", 48e9, 0.2}, 2800, 0.01, 1, 0.5, model, 60e-6 / 1000);
  EXPECT_NEAR(-pair.after.velocity.x, 0.55, 0.01);
}

TEST(Impact, chung_ooi_4_oblique_sliding) {
  // Aluminium oxide on aluminium alloy, 3.9 m/s; angles from the normal at which it slides throughout.
  const dem::Elastic oxide{"aluminium oxide", 380e9, 0.23};
  const dem::Elastic alloy{"aluminium alloy", 70e9, 0.33};
  const Real mu = 0.092;
  const Real en = 0.98;
  const Real radius = 2.5e-3;
  for (const Real degrees : {40.0, 50.0, 60.0, 70.0, 80.0, 85.0}) {
    const Real angle = degrees * pi / 180;
    const Real down = 3.9 * std::cos(angle);
    const Real along = 3.9 * std::sin(angle);
    const Impact hit =
        on_plane(oxide, alloy, 4000, radius, {along, 0, -down}, {en, mu}, 1e-5 / 1000);
    EXPECT_NEAR(hit.after.velocity.z / (en * down), 1, 5e-3) << degrees;
    EXPECT_NEAR(hit.after.velocity.x / (along - mu * (1 + en) * down), 1, 5e-3) << degrees;
    EXPECT_NEAR(hit.after.angular_velocity.y / (2.5 * mu * (1 + en) * down / radius), 1, 5e-3)
        << degrees;
  }
}

TEST(Impact, chung_ooi_4_against_the_digitised_data) {
  const char* given = std::getenv("PF_SHARED");
  const std::string shared = given != nullptr ? given : PF_SOURCE_DIR "/../shared";
  const std::string name = "/data/measurements/oblique_impact/chung_ooi_test4_sliding.csv";
  std::ifstream file(shared + name);
  if (!file) {
    GTEST_SKIP() << "needs ../shared" << name << " (or PF_SHARED)";
  }
  const dem::Elastic oxide{"aluminium oxide", 380e9, 0.23};
  const dem::Elastic alloy{"aluminium alloy", 70e9, 0.33};
  std::string line;
  std::getline(file, line);
  int rows = 0;
  for (; std::getline(file, line); ++rows) {
    std::istringstream cells(line);
    Real degrees = 0, restitution = 0, spin = 0, rebound = 0;
    char comma = 0;
    cells >> degrees >> comma >> restitution >> comma >> spin >> comma >> rebound;
    const Real angle = degrees * pi / 180;
    const Impact hit =
        on_plane(oxide, alloy, 4000, 2.5e-3, {3.9 * std::sin(angle), 0, -3.9 * std::cos(angle)},
                 {0.98, 0.092}, 1e-5 / 1000);
    const Vec3 v = hit.after.velocity;
    // As far as points can be read off the figure: the exact values are asserted above.
    EXPECT_NEAR(v.x / (3.9 * std::sin(angle)), restitution, 3e-3) << degrees;
    EXPECT_NEAR(-hit.after.angular_velocity.y, spin, 4) << degrees;
  }
  EXPECT_EQ(rows, 6);
}

}  // namespace porefines::test
