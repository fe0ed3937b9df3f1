// SPDX-License-Identifier: MPL-2.0
// The same particles enter on any number of ranks.
#include "dem/injection.hpp"

#include <numeric>

#include <gtest/gtest.h>

namespace porefines::dem {
namespace {

/// Particles from above into a box with a ball in it, moved between entries.
std::vector<Body> enter(const par::Communicator& comm) {
  Settings settings;
  settings.box = {{0, 0, 0}, {1, 1, 2}, {false, true, false}};
  settings.materials = MaterialTable({{"a", 1e5, 0.3}}, {});
  settings.walls = {Primitives{Ball{{0.5, 0.5, 2}, 0.2, false, {}}}};
  System system(comm, settings);
  Inlet inlet;
  inlet.face = BoxFace::z_high;
  inlet.high = {1, 1, 2};
  inlet.density = 1000;
  inlet.sizes = {0.1, 0.06, 0.2, NormalLaw{0.02}, false};
  inlet.by_number = true;
  inlet.rate = 300;
  inlet.stop = 1;
  inlet.velocity = 1;
  InletState state;
  std::uint64_t next_id = 0;
  std::vector<Body> all;
  for (int n = 0; n < 8; ++n) {
    const auto bodies = let_in(system, comm, inlet, state, 0.05 * n, 0.05 * (n + 1), next_id);
    all.insert(all.end(), bodies.begin(), bodies.end());
    system.advance(0.001, 50);
  }
  return all;
}

TEST(InjectionOnRanks, is_the_same_as_on_one) {
  const std::vector<Body> together = enter(par::Communicator());
  const std::vector<Body> alone = enter(par::Communicator::self());
  ASSERT_EQ(together.size(), alone.size());
  EXPECT_GT(alone.size(), 60U);
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_EQ(together[i].id, alone[i].id);
    EXPECT_EQ(together[i].position, alone[i].position);
    EXPECT_EQ(together[i].radius, alone[i].radius);
  }
}

}  // namespace
}  // namespace porefines::dem
