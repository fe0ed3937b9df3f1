// SPDX-License-Identifier: MPL-2.0
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "dem/surface.hpp"

namespace porefines::dem {

namespace {

TouchList touches(const Primitives& walls, const Vec3& centre, Real radius, Real reach) {
  TouchList out;
  find_touches(Surfaces{walls}, centre, radius, reach, out);
  return out;
}

void expect_near(const Vec3& a, const Vec3& b, Real tolerance) {
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(a[axis], b[axis], tolerance) << "axis " << axis;
  }
}

}  // namespace

TEST(DemPrimitive, gaps_normals_and_curvatures_are_exact) {
  const Primitives walls = checked({Plane{{0, 0, -1}, {0, 0, 3}}, Cylinder{{4, 0, 0}, {0, 2, 0}, 1},
                                    Cylinder{{0, 0, 0}, {0, 1, 0}, 2.5, true}, Ball{{0, 3, 0}, 1.5},
                                    Ball{{0, 0, 0}, 10, true}});
  const TouchList found = touches(walls, {1, 0.5, 0}, 0.9, 100);
  ASSERT_EQ(found.count, 5);
  EXPECT_FALSE(found.in_trouble());
  const auto& t = found.touch;
  EXPECT_NEAR(t[0].gap, 1 - 0.9, 1e-15);
  expect_near(t[0].normal, {0, 0, 1}, 1e-15);
  EXPECT_EQ(t[0].curvature, 0);
  EXPECT_NEAR(t[1].gap, 3 - 1 - 0.9, 1e-15);
  expect_near(t[1].normal, {-1, 0, 0}, 1e-15);
  EXPECT_NEAR(t[1].curvature, 0.5, 1e-15);
  EXPECT_NEAR(t[2].gap, 2.5 - 1 - 0.9, 1e-15);
  expect_near(t[2].normal, {-1, 0, 0}, 1e-15);
  EXPECT_NEAR(t[2].curvature, -0.2, 1e-15);
  EXPECT_NEAR(t[3].gap, std::sqrt(1 + 6.25) - 1.5 - 0.9, 1e-15);
  EXPECT_NEAR(t[4].gap, 10 - std::sqrt(1.25) - 0.9, 1e-15);
  EXPECT_NEAR(t[4].curvature, -0.1, 1e-15);
  for (std::uint32_t w = 0; w < 5; ++w) {
    EXPECT_EQ(t[w].feature, w);
  }
  EXPECT_EQ(touches(walls, {1, 0.5, 0}, 0.9, 0.11).count, 1);  // only the plane is that near
}

TEST(DemPrimitive, faces_of_a_box_all_touch_at_a_corner) {
  const Primitives walls = box_faces({0, 0, 0}, {1, 2, 3}, {true, true, true, true, false, true});
  ASSERT_EQ(walls.size(), 5U);
  const TouchList found = touches(walls, {0.1, 1.9, 2.9}, 0.1001, 0);
  ASSERT_EQ(found.count, 3);
  expect_near(found.touch[0].normal, {1, 0, 0}, 0);
  expect_near(found.touch[1].normal, {0, -1, 0}, 0);
  expect_near(found.touch[2].normal, {0, 0, -1}, 0);
  for (const Touch& touch : found.view()) {
    EXPECT_NEAR(touch.gap, -1e-4, 1e-15);
  }
}

TEST(DemPrimitive, a_turning_drum_carries_its_surface_and_a_falling_plate_moves) {
  const Motion spinning{{0, 0, 0}, {0, 0, 2}, {0, 0, 0}};
  Primitives walls{Cylinder{{0, 0, 0}, {0, 0, 1}, 5, true, spinning},
                   Plane{{0, 0, -4}, {0, 0, 1}, {{0, 0, 0.5}, {}, {}}},
                   Ball{{7, 0, 0}, 1, false, {{0, 1, 0}, {0, 0, 2}, {0, 0, 0}}}};
  const TouchList found = touches(walls, {4, 0, 0}, 0.9, 4);
  ASSERT_EQ(found.count, 3);
  expect_near(found.touch[0].velocity, {0, 10, 0}, 1e-14);
  expect_near(found.touch[1].velocity, {0, 0, 0.5}, 1e-15);
  expect_near(found.touch[2].velocity, {0, 13, 0}, 1e-14);
  for (int step = 0; step < 1000; ++step) {
    advance(walls, 1e-3);
  }
  expect_near(std::get<Plane>(walls[1]).point, {0, 0, -3.5}, 1e-12);
  expect_near(std::get<Ball>(walls[2]).centre, {7 * std::cos(2.0), 1 + 7 * std::sin(2.0), 0}, 1e-5);
  expect_near(std::get<Ball>(walls[2]).motion.about, {0, 1, 0}, 1e-12);
}

TEST(DemPrimitive, trouble_is_reported) {
  const Primitives walls{Plane{{0, 0, 0}, {0, 0, 1}}};
  EXPECT_TRUE(touches(walls, {0, 0, -0.1}, 1, 0).inside);
  EXPECT_TRUE(touches({Ball{{0, 0, 0}, 1, true}}, {0.1, 0, 0}, 1.2, 0).inside);
  EXPECT_TRUE(touches({Cylinder{{0, 0, 0}, {1, 0, 0}, 1}}, {3, 0, 0}, 0.2, 0).inside);
  const Primitives stack(20, walls[0]);
  const TouchList crowded = touches(stack, {0, 0, 0.5}, 1, 0);
  EXPECT_EQ(crowded.count, TouchList::capacity);
  EXPECT_EQ(crowded.lost, 4);
  EXPECT_TRUE(crowded.in_trouble());
  EXPECT_THROW((void)checked({Plane{{0, 0, 0}, {0, 0, 0}}}), InputError);
  EXPECT_THROW((void)checked({Ball{{0, 0, 0}, -1}}), InputError);
}

namespace {

struct Remembered {
  std::uint32_t feature;
  Vec3 normal;
};

Touch touch_at(std::uint32_t feature, Real angle) {
  return {{std::cos(angle), std::sin(angle), 0}, 0, {}, 0, 1, feature};
}

}  // namespace

TEST(DemTouch, history_follows_the_normal_that_turned_least) {
  const std::array<Remembered, 3> before{{{7, {1, 0, 0}}, {7, {0, 1, 0}}, {8, {0, 0, 1}}}};
  const Real right = std::acos(0.0);
  const auto look = [&](const std::vector<Touch>& touches) {
    return match_histories<Remembered>(touches, before);
  };
  EXPECT_EQ(look({touch_at(7, right - 0.2)})[0], 1);
  EXPECT_EQ(look({touch_at(7, right / 2)})[0], -1);
  EXPECT_EQ(look({touch_at(8, 0)})[0], -1);
}

TEST(DemTouch, a_newborn_touch_leaves_its_neighbours_history_alone) {
  const std::array<Remembered, 1> before{{{7, {1, 0, 0}}}};
  const Touch newborn = touch_at(7, 0.3);
  const Touch old = touch_at(7, 0.01);
  for (const bool newborn_first : {true, false}) {
    const std::vector<Touch> touches =
        newborn_first ? std::vector{newborn, old} : std::vector{old, newborn};
    const auto found = match_histories<Remembered>(touches, before);
    EXPECT_EQ(found[newborn_first ? 0 : 1], -1);
    EXPECT_EQ(found[newborn_first ? 1 : 0], 0);
  }
}

}  // namespace porefines::dem
