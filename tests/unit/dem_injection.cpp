// SPDX-License-Identifier: MPL-2.0
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "dem/injection.hpp"

namespace porefines::dem {
namespace {

Settings empty_box() {
  Settings settings;
  settings.box = {{0, 0, 0}, {1, 1, 4}, {false, true, false}};
  settings.materials = MaterialTable({{"a", 1e6, 0.3}}, {});
  return settings;
}

Inlet from_above() {
  Inlet inlet;
  inlet.face = BoxFace::z_high;
  inlet.high = {1, 1, 4};
  inlet.density = 1000;
  inlet.sizes.mean = 0.1;
  inlet.by_number = true;
  inlet.rate = 10;
  inlet.stop = 1e9;
  inlet.velocity = 1;
  return inlet;
}

/// A system, its inlet, and the clock.
struct Entry {
  System system;
  Inlet inlet;
  InletState state{};
  std::uint64_t next_id = 0;
  Real time = 0;
  std::vector<Body> all{};

  explicit Entry(const Inlet& through, const Settings& settings = empty_box())
      : system(par::Communicator::self(), settings), inlet(through) {}

  std::size_t let_in_until(Real to) {
    const auto bodies = let_in(system, par::Communicator::self(), inlet, state, time, to, next_id);
    all.insert(all.end(), bodies.begin(), bodies.end());
    time = to;
    return bodies.size();
  }
};

TEST(Injection, pulses_open_for_their_duration) {
  Inlet inlet = from_above();
  inlet.start = 1;
  inlet.stop = 10;
  inlet.period = 2;
  inlet.duration = 0.5;
  EXPECT_EQ(open_time(inlet, 0.9), 0);
  EXPECT_DOUBLE_EQ(open_time(inlet, 1.2), 0.2);
  EXPECT_DOUBLE_EQ(open_time(inlet, 2.9), 0.5);
  EXPECT_DOUBLE_EQ(open_time(inlet, 3.3), 0.8);
  EXPECT_DOUBLE_EQ(open_time(inlet, 99), open_time(inlet, 10));
}

TEST(Injection, times_follow_from_the_rate_not_from_the_steps) {
  // 10 per second: the k-th is due at k/10 s and has come 1 m/s x the time since, whatever the steps.
  for (const Real step : {0.017, 0.23, 1.0}) {
    Entry entry(from_above());
    std::size_t entered = 0;
    while (entry.time < 1 - 1e-12) {
      const Real to = std::min(entry.time + step, 1.0);
      for (std::size_t k = entry.let_in_until(to), n = 0; n < k; ++n) {
        const Real due = static_cast<Real>(++entered) / 10;
        const Real depth = 4 - entry.all[entered - 1].position.z;
        EXPECT_NEAR(depth, 0.05 * 1.001 + (to - due), 1e-9) << "particle " << entered;
      }
    }
    EXPECT_EQ(entered, 10U);
    EXPECT_EQ(entry.state.waiting, 0);
  }
}

TEST(Injection, volume_is_what_the_rate_says) {
  Inlet inlet = from_above();
  inlet.by_number = false;
  inlet.sizes = {0.1, 0.05, 0.2, LognormalLaw{0.03}, false};
  inlet.rate = 0.002;  // m^3/s
  Entry entry(inlet);
  for (int n = 1; n <= 40; ++n) {
    (void)entry.let_in_until(0.5 * n);
    entry.system.advance(1e-9, 1);
    (void)entry.system.remove([](const Particles&, std::size_t) { return true; });  // make room
  }
  Real volume = 0;
  for (const Body& body : entry.all) {
    volume += 4.0 / 3 * std::numbers::pi * std::pow(body.radius, 3);
  }
  EXPECT_NEAR(volume, 0.04, 4.2e-3);  // short of it by at most the largest particle
  EXPECT_LE(volume, 0.04 + 1e-12);
  EXPECT_GT(entry.all.size(), 40U);
}

TEST(Injection, nothing_overlaps_and_what_finds_no_room_waits) {
  Inlet inlet = from_above();
  inlet.rate = 1000;
  inlet.velocity = 1e-9;
  Entry entry(inlet);
  const std::size_t entered = entry.let_in_until(1);  // 1000 are due, a layer holds about 50
  EXPECT_GT(entered, 20U);
  EXPECT_LT(entered, 120U);
  EXPECT_EQ(entry.state.waiting, 1000 - static_cast<Index>(entered));
  for (std::size_t i = 0; i < entered; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      Vec3 d = entry.all[i].position - entry.all[j].position;
      d.y -= std::round(d.y);
      EXPECT_GT(norm(d), 0.1);
    }
  }
  // They come in when there is room, oldest first, and the rate is made up for.
  (void)entry.system.remove([](const Particles&, std::size_t) { return true; });
  EXPECT_GT(entry.let_in_until(1.001), 20U);
  for (std::size_t i = 0; i < entry.all.size(); ++i) {
    EXPECT_EQ(entry.all[i].id, i);
  }
}

TEST(Injection, follows_the_flux_of_a_flow) {
  // Shear flow u_z = -2 x: density of entries 2 x, mean of x is 2/3, at the speed found there.
  Inlet inlet = from_above();
  inlet.sizes.mean = 1e-3;
  inlet.flow = [](const Vec3& x) { return Vec3{0, 0, -2 * x.x}; };
  inlet.fastest_flow = 2;
  inlet.rate = 2000;
  Entry entry(inlet);
  (void)entry.let_in_until(1);
  ASSERT_EQ(entry.all.size(), 2000U);
  Real sum = 0;
  for (const Body& body : entry.all) {
    sum += body.position.x;
    EXPECT_DOUBLE_EQ(body.velocity.z, -2 * body.position.x);
  }
  EXPECT_NEAR(sum / 2000, 2.0 / 3, 5 * std::sqrt(1.0 / 18 / 2000));
}

TEST(Injection, keeps_out_of_walls_and_says_when_rock_shuts_the_window) {
  Settings settings = empty_box();
  settings.walls = {Primitives{Plane{{0.5, 0, 0}, {-1, 0, 0}, {}}}};  // rock beyond x = 1/2
  Entry entry(from_above(), settings);
  EXPECT_NEAR(open_share(entry.system, par::Communicator::self(), entry.inlet), 0.4 / 0.9, 0.1);
  (void)entry.let_in_until(1);
  EXPECT_EQ(entry.all.size(), 10U);
  for (const Body& body : entry.all) {
    EXPECT_LT(body.position.x, 0.45);
  }
  entry.inlet.low.x = 0.6;
  EXPECT_EQ(open_share(entry.system, par::Communicator::self(), entry.inlet), 0);
}

}  // namespace
}  // namespace porefines::dem
