// SPDX-License-Identifier: MPL-2.0
#include <gtest/gtest.h>

#include "flow/face_network.hpp"

namespace porefines::flow {
namespace {

constexpr Real quarter = 0.25;  // area of a fine face in a coarse one

/// Open pore without walls, all mobilities 1: what coarse_mobility makes of it.
FaceNetwork open_pore() {
  FaceNetwork net;
  net.middle.fill(quarter / 0.5);
  net.outer.fill(quarter / 0.25);
  for (int side = 0; side < 2; ++side) {
    for (int i = 0; i < 2; ++i) {
      net.across[0][FaceNetwork::cell(side, 0, i)] = 1;
      net.across[1][FaceNetwork::cell(side, i, 0)] = 1;
    }
  }
  net.sideways.fill(true);
  return net;
}

/// Only the cells and faces of a path stay.
FaceNetwork solid() {
  return {};
}

TEST(FaceNetwork, open_pore_has_the_mobility_of_its_faces) {
  EXPECT_NEAR(effective_conductance(open_pore()), 1, 1e-12);
}

TEST(FaceNetwork, conductances_across_the_flow_add_up) {
  FaceNetwork net = open_pore();
  net.middle[1] = net.middle[2] = net.middle[3] = 0;
  net.across = {};  // one straight tube of four
  EXPECT_NEAR(effective_conductance(net), 0.25, 1e-12);
}

TEST(FaceNetwork, resistances_along_the_flow_add_up) {
  FaceNetwork net = solid();
  net.outer[0] = 1;
  net.middle[0] = 0.5;
  net.outer[4] = 0.01;
  EXPECT_NEAR(effective_conductance(net), 1 / (1 + 2 + 100.0), 1e-12);
}

/// The way in is beside the way on: the step across the flow resists too.
TEST(FaceNetwork, a_turn_inside_a_coarse_cell_resists) {
  FaceNetwork net = solid();
  net.outer[FaceNetwork::cell(0, 1, 0)] = 1;
  net.across[0][FaceNetwork::cell(0, 0, 0)] = 0.1;
  net.middle[FaceNetwork::cell(0, 0, 0)] = 0.5;
  net.outer[FaceNetwork::cell(1, 0, 0)] = 1;
  EXPECT_NEAR(effective_conductance(net), 1 / (1 + 10 + 2 + 1.0), 1e-12);
}

TEST(FaceNetwork, what_comes_from_the_side_is_held_by_its_coarse_cell) {
  FaceNetwork net = solid();
  net.middle[0] = 0.5;
  net.outer[4] = 1;
  EXPECT_EQ(effective_conductance(net), 0) << "a dead end below the face";
  net.sideways[0] = true;
  EXPECT_NEAR(effective_conductance(net), 1 / (2 + 1.0), 1e-5);
}

}  // namespace
}  // namespace porefines::flow
