// SPDX-License-Identifier: MPL-2.0
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "dem/surface.hpp"
#include "dem/wall_sight.hpp"

namespace porefines::dem {

namespace {

constexpr Real radius = 0.05;
constexpr Real reach = 0.01;

/// Two grains as round as the sphere, which sits in the wedge between them.
Surfaces two_grains() {
  const std::vector<geom::Body> bodies{{{0.44, 0.5, 0.5}, radius}, {{0.56, 0.5, 0.5}, radius}};
  const geom::SampleBox box{{1, 1, 1},
                            {geom::Beyond::pore, geom::Beyond::pore, geom::Beyond::pore}};
  return {Fixed(RoundGrains<3>{geom::RoundBodies<3>(bodies, box, true, 0.1), {}})};
}

TouchList seen_from(const Surfaces& surfaces, const Vec3& x) {
  TouchList out;
  find_touches(surfaces, x, radius, reach, out);
  return out;
}

}  // namespace

TEST(Sight, is_what_a_search_would_find_where_the_sphere_has_hardly_moved) {
  const Surfaces surfaces = two_grains();
  const Vec3 start{0.5, 0.5802, 0.5};
  Sight sight;
  sight.keep(start, reach, seen_from(surfaces, start));
  std::mt19937 random(3);
  std::normal_distribution<Real> normal;
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3 way{normal(random), normal(random), normal(random)};
    const Vec3 x = start + (0.99 * Sight::far_enough * radius / norm(way)) * way;
    TouchList recalled;
    ASSERT_TRUE(sight.recall(x, radius, reach, recalled));
    const TouchList found = seen_from(surfaces, x);
    ASSERT_EQ(recalled.count, 2);
    ASSERT_EQ(found.count, 2);
    for (int t = 0; t < 2; ++t) {
      EXPECT_NEAR(recalled.touch[t].gap, found.touch[t].gap, 5e-8 * radius);
      EXPECT_GT(dot(recalled.touch[t].normal, found.touch[t].normal), 1 - 1e-7);
    }
  }
}

TEST(Sight, ends_where_the_sphere_has_gone_farther_or_more_is_asked_for) {
  const Surfaces surfaces = two_grains();
  const Vec3 start{0.5, 0.5802, 0.5};
  Sight sight;
  TouchList out;
  EXPECT_FALSE(sight.recall(start, radius, reach, out));
  sight.keep(start, reach, seen_from(surfaces, start));
  EXPECT_FALSE(
      sight.recall(start + Vec3{1.01 * Sight::far_enough * radius, 0, 0}, radius, reach, out));
  EXPECT_FALSE(sight.recall(start, radius, 2 * reach, out));
  EXPECT_TRUE(sight.recall(start, radius, reach, out));
  sight.forget();
  EXPECT_FALSE(sight.recall(start, radius, reach, out));
}

TEST(Sight, loses_a_touch_that_has_left_its_reach) {
  const Surfaces surfaces = two_grains();
  const Vec3 start{0.5, 0.5 + std::sqrt(0.1 * 0.1 - 0.06 * 0.06) - 1e-7, 0.5};  // touching, barely
  TouchList touching;
  find_touches(surfaces, start, radius, 0, touching);
  ASSERT_EQ(touching.count, 2);
  Sight sight;
  sight.keep(start, 0, touching);
  TouchList out;
  ASSERT_TRUE(sight.recall(start + Vec3{0, 1e-6, 0}, radius, 0, out));
  EXPECT_EQ(out.count, 0);
}

}  // namespace porefines::dem
