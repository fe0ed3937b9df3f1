// SPDX-License-Identifier: MPL-2.0
#include "analysis/near_points.hpp"

#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace porefines::analysis {
namespace {

using Pairs = std::set<std::pair<int, int>>;

Pairs near_pairs(const std::vector<Vec3>& points, Real distance, const PointBox& box,
                 Index& looked_at) {
  const NearPoints near(points, distance, box);
  Pairs pairs;
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    std::set<int> seen;
    near.visit(points[static_cast<std::size_t>(i)], [&](std::int32_t j, const Vec3& way) {
      ++looked_at;
      EXPECT_TRUE(seen.insert(j).second) << "visited twice";
      if (norm(way) <= distance) {
        pairs.emplace(i, j);
      }
    });
  }
  return pairs;
}

Pairs all_pairs(const std::vector<Vec3>& points, Real distance, const PointBox& box) {
  Pairs pairs;
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    for (int j = 0; j < static_cast<int>(points.size()); ++j) {
      Vec3 way = points[static_cast<std::size_t>(j)] - points[static_cast<std::size_t>(i)];
      for (int a = 0; a < 3; ++a) {
        if (box.periodic[static_cast<std::size_t>(a)]) {
          way[a] = std::remainder(way[a], box.size[a]);
        }
      }
      if (norm(way) <= distance) {
        pairs.emplace(i, j);
      }
    }
  }
  return pairs;
}

}  // namespace

TEST(NearPoints, finds_the_pairs_that_a_look_at_all_finds) {
  Draws draws(7, Stream::place, 1);
  for (const std::array<bool, 3>& periodic :
       {std::array<bool, 3>{}, std::array{true, false, true}, std::array{true, true, true}}) {
    for (const Real distance : {0.03, 0.2, 0.45, 1.0}) {
      const PointBox box{{1, 2, 0.5}, periodic};
      std::vector<Vec3> points;
      for (int i = 0; i < 120; ++i) {  // some beyond the box
        points.push_back(
            {draws.uniform(-0.1, 1.1), draws.uniform(-0.1, 2.1), draws.uniform(0, 0.5)});
      }
      const Real most = periodic[2] ? std::min(distance, 0.25) : distance;  // half the box
      Index looked_at = 0;
      EXPECT_EQ(near_pairs(points, most, box, looked_at), all_pairs(points, most, box));
    }
  }
}

TEST(NearPoints, work_grows_like_the_points_at_the_same_density) {
  Draws draws(7, Stream::place, 2);
  std::vector<Real> per_point;
  for (const int n : {1000, 16000}) {  // in a thin chip
    const Real edge = 0.01 * std::sqrt(n);
    std::vector<Vec3> points;
    for (int i = 0; i < n; ++i) {
      points.push_back({draws.uniform(0, edge), draws.uniform(0, edge), draws.uniform(0, 0.01)});
    }
    Index looked_at = 0;
    (void)near_pairs(points, 0.01, {{edge, edge, 0.01}, {}}, looked_at);
    per_point.push_back(static_cast<Real>(looked_at) / n);
  }
  EXPECT_LT(per_point[1], 1.2 * per_point[0]);
  EXPECT_LT(per_point[1], 20);
}

TEST(NearPoints, from_outside_of_all_points_finds_those_within_the_distance) {
  const std::vector<Vec3> points{{3, 3, 3}, {3.2, 3, 3}, {3, 3.4, 3}};
  for (const std::size_t some : {1U, 3U}) {
    const NearPoints near(std::span<const Vec3>(points).first(some), 2, {{10, 10, 10}, {}});
    for (const Vec3& off : {Vec3{-1.9, 0, 0}, Vec3{1.9, 0, 0}, Vec3{0, -1.3, 1.3}}) {
      bool found = false;
      near.visit(points[0] + off, [&](std::int32_t j, const Vec3&) { found = found || j == 0; });
      EXPECT_TRUE(found);
    }
  }
}

TEST(NearPoints, of_nothing_and_of_one_place) {
  const NearPoints none({}, 1, {{1, 1, 1}, {}});
  none.visit({}, [](std::int32_t, const Vec3&) { FAIL(); });
  const std::vector<Vec3> same(5, Vec3{0.3, 0.3, 0.3});
  const NearPoints near(same, 0.1, {{1, 1, 1}, {}});
  int count = 0;
  near.visit({0.35, 0.3, 0.3}, [&](std::int32_t, const Vec3&) { ++count; });
  EXPECT_EQ(count, 5);
}

}  // namespace porefines::analysis
