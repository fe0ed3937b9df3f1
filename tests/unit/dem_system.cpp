// SPDX-License-Identifier: MPL-2.0
#include <functional>
#include <map>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "support/spheres.hpp"

namespace porefines::test {

namespace {

using dem::Settings;
using dem::System;
using dem::Totals;

constexpr Real d = 5e-6;

/// 512 latex spheres, a third of the volume, that collide in a periodic or a walled cube.
System colliding(bool periodic, const dem::ContactModel& model, Real restitution) {
  Settings s = cube(8.6 * d, periodic, latex, {restitution, 0.5, 0.1, 0.3});
  s.model = model;
  if (!periodic) {
    s.walls.emplace_back(
        dem::box_faces(s.box.low, s.box.high, {true, true, true, true, true, true}));
  }
  System system(par::Communicator::self(), s);
  system.insert(gas(8, 8.6 * d, d / 2, 1.2, 0.1, 3));
  return system;
}

constexpr Real dt = 2e-8;

bool same_state(const dem::Particles& a, const dem::Particles& b) {
  return a.owned == b.owned && std::equal(a.id.begin(), a.id.begin() + a.owned, b.id.begin()) &&
         std::equal(a.position.begin(), a.position.begin() + a.owned, b.position.begin()) &&
         std::equal(a.velocity.begin(), a.velocity.begin() + a.owned, b.velocity.begin()) &&
         std::equal(a.angular_velocity.begin(), a.angular_velocity.begin() + a.owned,
                    b.angular_velocity.begin()) &&
         std::equal(a.force.begin(), a.force.begin() + a.owned, b.force.begin());
}

}  // namespace

TEST(DemSystem, momentum_is_kept_to_round_off) {
  System system = colliding(true, {}, 0.5);
  const Totals before = system.totals();
  system.advance(dt, 3000);
  const Totals after = system.totals();
  EXPECT_GT(after.contacts, 20);
  EXPECT_GT(system.work().rebuilds, 3);
  const Real scale = std::sqrt(2 * before.kinetic * 512 * system.particles().mass[0]);
  EXPECT_LT(norm(after.momentum - before.momentum), 1e-12 * scale);
  EXPECT_LT(after.kinetic, 0.9 * before.kinetic);
}

TEST(DemSystem, angular_momentum_is_kept_to_round_off) {
  // A cluster flying together in an open box: no walls, no periodic images.
  Settings s = cube(100 * d, false, latex, {0.7, 0.5, 0.1, 0.3});
  s.model.rolling = dem::RollingSpring{};
  System system(par::Communicator::self(), s);
  auto bodies = gas(5, 5.5 * d, d / 2, 1.2, 0.1, 5);
  for (auto& b : bodies) {
    b.position += {40 * d, 40 * d, 40 * d};
    const Vec3 centre{42.75 * d, 42.75 * d, 42.75 * d};
    b.velocity -= 6e3 * (b.position - centre);
  }
  system.insert(bodies);
  const Totals before = system.totals();
  system.advance(dt, 3000);
  const Totals after = system.totals();
  EXPECT_LT(after.kinetic, 0.8 * before.kinetic);
  const Real scale = 125 * system.particles().mass[0] * 0.1 * 45 * d;
  EXPECT_LT(norm(after.angular_momentum - before.angular_momentum), 1e-12 * scale);
}

TEST(DemSystem, energy_never_grows) {
  for (const auto& rolling : {decltype(dem::ContactModel::rolling){dem::Unresisted{}},
                              decltype(dem::ContactModel::rolling){dem::ConstantTorque{}},
                              decltype(dem::ContactModel::rolling){dem::RollingSpring{}}}) {
    for (const bool periodic : {true, false}) {
      dem::ContactModel model;
      model.rolling = rolling;
      System system = colliding(periodic, model, 0.8);
      const auto energy = [&system] {
        const Totals t = system.totals();
        return t.kinetic + t.rotational + t.elastic;
      };
      const Real first = energy();
      Real before = first;
      for (int block = 0; block < 100; ++block) {
        system.advance(dt / 2, 20);
        const Real now = energy();
        EXPECT_LT(now, before + 1e-5 * first);
        before = now;
      }
      EXPECT_LT(before, 0.9 * first);
    }
  }
}

TEST(DemSystem, elastic_collisions_keep_the_energy) {
  Settings s = cube(8.6 * d, true, latex, {1.0, 0.0});
  System system(par::Communicator::self(), s);
  system.insert(gas(8, 8.6 * d, d / 2, 1.2, 0.1, 3));
  const Totals before = system.totals();
  system.advance(dt / 4, 8000);
  const Totals after = system.totals();
  EXPECT_GT(after.elastic, 0);
  EXPECT_NEAR((after.kinetic + after.rotational + after.elastic) /
                  (before.kinetic + before.rotational + before.elastic),
              1, 2e-4);
}

TEST(DemSystem, n_plus_n_steps_are_two_n_bit_for_bit) {
  for (const bool periodic : {true, false}) {
    dem::ContactModel model;
    model.rolling = dem::RollingSpring{};
    System whole = colliding(periodic, model, 0.8);
    whole.advance(dt, 1000);
    const dem::Snapshot half = whole.save();
    EXPECT_GT(half.moved, 0);
    EXPECT_GT(half.contacts.entries.size(), 40U);
    whole.advance(dt, 1000);
    System resumed(par::Communicator::self(), whole.settings());
    resumed.restore(half, true);
    resumed.advance(dt, 400);
    resumed.advance(dt, 600);
    EXPECT_TRUE(same_state(whole.particles(), resumed.particles()));
  }
}

TEST(DemSystem, lists_do_not_change_the_answer) {
  // Skins from thin to thick: other rebuilds, other orders; the same motion until chaos.
  std::vector<Vec3> positions[2];
  for (const int run : {0, 1}) {
    Settings s = cube(8.6 * d, true, latex, {0.8, 0.5});
    s.skin = (run == 0 ? 0.02 : 0.5) * d;
    System system(par::Communicator::self(), s);
    system.insert(gas(8, 8.6 * d, d / 2, 1.2, 0.1, 3));
    system.advance(dt, 400);
    for (std::uint64_t id = 1; id <= 512; ++id) {
      positions[run].push_back(
          s.box.wrapped(system.particles().position[find(system.particles(), id)]));
    }
  }
  for (std::size_t k = 0; k < 512; ++k) {
    EXPECT_LT(norm(positions[0][k] - positions[1][k]), 1e-11 * d);
  }
}

TEST(DemSystem, a_held_particle_stays_and_feels) {
  Settings s = cube(10 * d, false, latex, {0.5, 0.5});
  s.gravity = {0, 0, -9.81};
  System system(par::Communicator::self(), s);
  dem::Body held = sphere(1, {5 * d, 5 * d, 5 * d}, d / 2, 1050);
  held.flags = dem::flag::fixed;
  const std::vector<dem::Body> bodies{held, sphere(2, {5 * d, 5 * d, 6 * d}, d / 2, 1050)};
  system.insert(bodies);
  system.advance(dt, 20000);
  const auto& p = system.particles();
  const std::size_t i = find(p, 1);
  EXPECT_EQ(p.position[i], held.position);
  EXPECT_NEAR(p.force[i].z / (p.mass[i] * -9.81), 1, 1e-3);
}

/// Forces of the contacts among particles that keep(id), by the pair's ids.
std::map<std::pair<std::uint64_t, std::uint64_t>, Vec3> forces(
    const System& system, const std::function<bool(std::uint64_t)>& keep) {
  std::map<std::pair<std::uint64_t, std::uint64_t>, Vec3> found;
  for (const dem::ContactRecord& c : system.contacts()) {
    if (keep(c.first) && (c.wall || keep(c.second))) {
      const bool turned = !c.wall && c.second < c.first;
      found[turned ? std::pair{c.second, c.first} : std::pair{c.first, c.second}] =
          turned ? -1.0 * c.force : c.force;
    }
  }
  return found;
}

TEST(DemSystem, those_who_come_and_go_leave_the_contacts_of_the_rest) {
  System system = colliding(false, {}, 0.8);
  system.advance(dt, 1000);
  const auto stays = [](std::uint64_t id) { return id > 12 && id <= 512; };
  const auto before = forces(system, stays);
  ASSERT_GT(before.size(), 20U);
  const auto expect_kept = [&] {
    const auto now = forces(system, stays);
    ASSERT_EQ(now.size(), before.size());
    for (const auto& [pair, force] : before) {
      ASSERT_TRUE(now.contains(pair));
      EXPECT_LT(norm(now.at(pair) - force), 1e-9 * norm(force));  // friction's history in it
    }
  };
  EXPECT_EQ(system.remove([](const auto& p, std::size_t k) { return p.id[k] <= 12; }), 12);
  EXPECT_EQ(system.totals().particles, 500);
  expect_kept();
  const dem::Particles& p = system.particles();
  system.insert(std::vector{
      sphere(600, p.position[find(p, 300)] + Vec3{0.01 * d, 0, 0.02 * d}, d / 4, 1050)});
  expect_kept();
  EXPECT_FALSE(forces(system, [](std::uint64_t id) { return id == 300 || id == 600; }).empty())
      << "the newcomer's contacts are known at once";
  const Index rebuilds = system.work().rebuilds;
  EXPECT_EQ(system.remove([](const auto&, std::size_t) { return false; }), 0);
  EXPECT_EQ(system.work().rebuilds, rebuilds) << "nothing to do";
}

TEST(DemSystem, refuses_wrong_bodies) {
  Settings s = cube(10 * d, false, latex, {});
  System system(par::Communicator::self(), s);
  const auto insert = [&](dem::Body b) { system.insert(std::vector<dem::Body>{b}); };
  EXPECT_THROW(insert(sphere(1, {5 * d, 5 * d, 5 * d}, 0, 1050)), InputError);
  EXPECT_THROW(insert(sphere(1, {5 * d, 5 * d, 5 * d}, d, -1)), InputError);
  EXPECT_THROW(insert(sphere(1, {50 * d, 5 * d, 5 * d}, d, 1050)), InputError);
  dem::Body b = sphere(1, {5 * d, 5 * d, 5 * d}, d, 1050);
  b.species = 3;
  EXPECT_THROW(insert(b), InputError);
}

TEST(DemSystem, stops_when_speeds_are_not_numbers) {
  Settings s = cube(10 * d, false, latex, {});
  System system(par::Communicator::self(), s);
  dem::Body b = sphere(1, {5 * d, 5 * d, 5 * d}, d, 1050);
  b.velocity.x = std::nan("");
  system.insert(std::vector<dem::Body>{b});
  EXPECT_THROW(system.advance(dt, 1), RunError);
}

}  // namespace porefines::test
