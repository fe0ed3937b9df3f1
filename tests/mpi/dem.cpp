// SPDX-License-Identifier: MPL-2.0
// Particles do not notice the seams between ranks: one rank moves alone what all move together.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "support/spheres.hpp"

namespace porefines::test {

namespace {

using dem::System;

constexpr Real d = 5e-6;
constexpr Real dt = 2e-8;

dem::Settings settings(bool periodic) {
  dem::Settings s = cube(14 * d, periodic, latex, {0.8, 0.5, 0.1, 0.3});
  s.model.rolling = dem::RollingSpring{};
  if (!periodic) {
    s.gravity = {500, 0, -1000};
    s.walls.emplace_back(
        dem::box_faces(s.box.low, s.box.high, {true, true, true, true, true, true}));
  }
  return s;
}

/// A colliding cloud; every eighth sphere has its centre on a seam of two or four blocks.
std::vector<dem::Body> cloud() {
  auto bodies = gas(13, 14 * d, d / 2, 1.1, 0.1, 11);
  for (std::size_t n = 0; n < bodies.size(); n += 8) {
    const Vec3 x = bodies[n].position;
    bodies[n].position[n % 3] = std::abs(x[n % 3] - 7 * d) < d / 4 ? 7 * d : x[n % 3];
  }
  return bodies;
}

/// What moved where: compared particle by particle over all ranks.
struct Largest {
  Real position = 0;
  Real velocity = 0;
  Index compared = 0;
};

Largest difference(const System& alone, const System& together, const par::Communicator& comm) {
  std::vector<std::size_t> where(13 * 13 * 13 + 1);
  for (std::size_t i = 0; i < alone.particles().owned; ++i) {
    where[alone.particles().id[i]] = i;
  }
  Largest out;
  const auto& p = together.particles();
  const auto& q = alone.particles();
  const dem::Box& box = alone.settings().box;
  for (std::size_t i = 0; i < p.owned; ++i) {
    const std::size_t j = where[p.id[i]];
    Vec3 apart = p.position[i] - q.position[j];
    for (int a = 0; a < 3; ++a) {
      apart[a] -= box.periodic[a] ? box.length(a) * std::round(apart[a] / box.length(a)) : 0;
    }
    out.position = std::max(out.position, norm(apart));
    out.velocity = std::max(out.velocity, norm(p.velocity[i] - q.velocity[j]));
  }
  out.position = comm.max(out.position), out.velocity = comm.max(out.velocity);
  out.compared = comm.sum(static_cast<Index>(p.owned));
  return out;
}

}  // namespace

TEST(DemRanks, same_trajectories) {
  for (const bool periodic : {true, false}) {
    System alone(par::Communicator::self(), settings(periodic));
    System together(par::Communicator(), settings(periodic));
    alone.insert(cloud());
    together.insert(cloud());
    for (const Index steps : {1, 299}) {
      alone.advance(dt, steps);
      together.advance(dt, steps);
    }
    const Largest off = difference(alone, together, par::Communicator());
    EXPECT_EQ(off.compared, 13 * 13 * 13);
    EXPECT_LT(off.position, 1e-10 * d);
    EXPECT_LT(off.velocity, 1e-10 * 0.1);
    const auto a = alone.totals();
    const auto b = together.totals();
    EXPECT_GT(a.contacts, 100);
    EXPECT_EQ(a.contacts, b.contacts);
    EXPECT_EQ(a.wall_contacts, b.wall_contacts);
    EXPECT_NEAR(b.elastic / a.elastic, 1, 1e-9);
    EXPECT_NEAR(together.largest_overlap() / alone.largest_overlap(), 1, 1e-9);
    EXPECT_GE(alone.work().rebuilds, 2);
  }
}

TEST(DemRanks, momentum_is_kept_across_seams) {
  System system(par::Communicator(), settings(true));
  system.insert(cloud());
  const auto before = system.totals();
  system.advance(dt, 300);
  const auto after = system.totals();
  const Real mass = 1050 * 4.0 / 3 * std::numbers::pi * std::pow(d / 2, 3);
  EXPECT_LT(norm(after.momentum - before.momentum), 1e-12 * 2197 * mass * 0.1);
}

TEST(DemRanks, same_number_same_bits_also_after_a_restart) {
  System first(par::Communicator(), settings(true));
  System second(par::Communicator(), settings(true));
  first.insert(cloud());
  second.insert(cloud());
  first.advance(dt, 300);
  second.advance(dt, 150);
  System resumed(par::Communicator(), settings(true));
  resumed.restore(second.save(), true);
  resumed.advance(dt, 150);
  ASSERT_EQ(first.particles().owned, resumed.particles().owned);
  for (std::size_t i = 0; i < first.particles().owned; ++i) {
    ASSERT_EQ(first.particles().id[i], resumed.particles().id[i]);
    ASSERT_EQ(first.particles().position[i], resumed.particles().position[i]);
    ASSERT_EQ(first.particles().velocity[i], resumed.particles().velocity[i]);
    ASSERT_EQ(first.particles().angular_velocity[i], resumed.particles().angular_velocity[i]);
  }
}

TEST(DemRanks, removal_and_late_insertion) {
  System alone(par::Communicator::self(), settings(true));
  System together(par::Communicator(), settings(true));
  for (System* system : {&alone, &together}) {
    auto bodies = cloud();
    const std::vector<dem::Body> late(bodies.end() - 100, bodies.end());
    bodies.resize(bodies.size() - 100);
    system->insert(bodies);
    system->advance(dt, 20);
    system->insert(late);
    system->advance(dt, 100);
    (void)system->remove([](const auto& p, std::size_t i) { return p.id[i] % 7 == 0; });
    system->advance(dt, 100);
  }
  const Largest off = difference(alone, together, par::Communicator());
  EXPECT_EQ(off.compared, alone.totals().particles);
  EXPECT_LT(off.position, 1e-10 * d);
}

TEST(DemRanks, creeping_crowd) {
  // Overdamped spheres driven towards the middle of the box, which is a corner of the blocks.
  const auto run = [](const par::Communicator& comm) {
    dem::Settings s = settings(true);
    s.materials.soften(1e-4);
    System system(comm, s);
    system.start_creeping();
    system.insert(gas(12, 14 * d, d / 2, 1.1, 0, 11));
    Index substeps = 0;
    for (int step = 0; step < 5; ++step) {
      auto& p = system.particles();
      for (std::size_t i = 0; i < p.owned; ++i) {
        const Vec3 x = s.box.wrapped(p.position[i]);
        const auto inwards = [](Real q) {
          return -1e-3 * std::sin(2 * std::numbers::pi * q / (14 * d));
        };
        p.creeping.free_velocity[i] = {-inwards(x.x), -inwards(x.y), -inwards(x.z)};
        p.creeping.resistance[i] = 6 * std::numbers::pi * 1e-3 * p.radius[i];
        p.creeping.spin_resistance[i] = 8 * std::numbers::pi * 1e-3 * std::pow(p.radius[i], 3);
      }
      substeps += system.creep(4e-4, {1e-3 * d}).substeps;
    }
    EXPECT_GT(substeps, 20);
    return system;
  };
  const System alone = run(par::Communicator::self());
  const System together = run(par::Communicator());
  const Largest off = difference(alone, together, par::Communicator());
  EXPECT_EQ(off.compared, 12 * 12 * 12);
  EXPECT_GT(alone.totals().contacts, 50);
  EXPECT_LT(off.position, 1e-10 * d);
}

TEST(DemRanks, messages_per_step_do_not_grow_with_particles) {
  System system(par::Communicator(), settings(true));
  system.insert(cloud());
  system.advance(dt, 10);
  const auto before = system.work();
  system.advance(dt, 100);
  const auto after = system.work();
  const Index lists = after.rebuilds - before.rebuilds + after.narrowings - before.narrowings;
  EXPECT_LT(lists, 20);
  EXPECT_LE(after.messages - before.messages, 6 * 100 + 30 * lists);
}

}  // namespace porefines::test
