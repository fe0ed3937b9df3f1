// SPDX-License-Identifier: MPL-2.0
#include <random>

#include <gtest/gtest.h>

#include "dem/surface.hpp"
#include "dem/surface_foot.hpp"
#include "support/sampled.hpp"

namespace porefines::dem {

using test::Distance;

namespace {

/// All lengths in voxels.
TouchList touches(const DistanceField& field, const Vec3& centre, Real radius, Real reach) {
  TouchList out;
  find_touches(field, centre, radius, reach, out);
  return out;
}

Vec3 random_direction(std::mt19937& random) {
  std::normal_distribution<Real> normal;
  const Vec3 v{normal(random), normal(random), normal(random)};
  return v / norm(v);
}

Distance ball(const Vec3& centre, Real radius) {
  return [=](const Vec3& x) { return norm(x - centre) - radius; };
}

Distance unite(const Distance& a, const Distance& b) {
  return [=](const Vec3& x) { return std::min(a(x), b(x)); };
}

/// Half space with the inward normal at an angle from x in the plane z = const.
Distance half_space(const Vec3& through, Real angle) {
  const Vec3 n{std::cos(angle), std::sin(angle), 0};
  return [=](const Vec3& x) { return dot(x - through, n); };
}

/// Grains as a rock has them: many overlapping balls.
Distance rubble(int size, int count, unsigned seed, Real smallest = 5, Real largest = 10) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<Real> uniform(0, 1);
  Distance all = [](const Vec3&) { return 1e3; };
  for (int b = 0; b < count; ++b) {
    const Vec3 c{size * uniform(random), size * uniform(random), size * uniform(random)};
    all = unite(all, ball(c, smallest + (largest - smallest) * uniform(random)));
  }
  return all;
}

}  // namespace

TEST(SurfaceSpline, is_of_fourth_order_and_gives_its_own_derivatives) {
  std::array<Real, 2> error{};
  for (const int refine : {1, 2}) {
    const int n = 14 * refine;
    const Real h = 1.0 / refine;
    const auto wave = [&](const Vec3& x) {
      return 2 * std::sin(0.5 * h * x.x) * std::cos(0.4 * h * x.y + 0.3 * h * x.z);
    };
    const SurfaceSpline spline = make_spline(test::sampled({n, n, n}, 1, wave));
    std::mt19937 random(1);
    std::uniform_real_distribution<Real> uniform(4, n - 4.0);
    for (int trial = 0; trial < 200; ++trial) {
      const Vec3 x{uniform(random), uniform(random), uniform(random)};
      const Jet jet = spline.jet(x - Vec3{0.5, 0.5, 0.5});
      Real& worst = error[static_cast<std::size_t>(refine - 1)];
      worst = std::max(worst, std::abs(jet.f - wave(x)));
      constexpr Real e = 1e-4;
      for (int axis = 0; axis < 3; ++axis) {
        Vec3 ahead = x - Vec3{0.5, 0.5, 0.5};
        Vec3 behind = ahead;
        ahead[axis] += e;
        behind[axis] -= e;
        const Jet a = spline.jet(ahead);
        const Jet b = spline.jet(behind);
        EXPECT_NEAR(jet.g[axis], (a.f - b.f) / (2 * e), 1e-6);
        const std::array<std::array<Real, 3>, 3> second{
            {{jet.xx, jet.xy, jet.xz}, {jet.xy, jet.yy, jet.yz}, {jet.xz, jet.yz, jet.zz}}};
        for (int other = 0; other < 3; ++other) {
          EXPECT_NEAR(second[axis][other], (a.g[other] - b.g[other]) / (2 * e), 1e-6);
        }
      }
    }
  }
  EXPECT_LT(error[0], 2e-2);
  EXPECT_GT(error[0] / error[1], 12);  // 16 for fourth order
}

// The grain's radius is that of the reference shape, sampled exactly: 4, 8, 16 voxels per particle.
TEST(DistanceField, gap_to_a_round_grain_is_exact_to_a_thousandth_of_the_diameter) {
  std::mt19937 random(2);
  for (const auto& [d, tolerance] : {std::pair{4.0, 2e-3}, {8.0, 2e-4}, {16.0, 2e-5}}) {
    for (const Real grain : {0.7 * d, 1.5 * d}) {
      const int n = static_cast<int>(2 * (grain + d) + 18);
      const Vec3 c{n / 2 + 0.37, n / 2 - 0.21, n / 2 + 0.11};
      const auto field = make_field(test::sampled({n, n, n}, 1, ball(c, grain)), d / 2 + 0.5);
      for (int trial = 0; trial < 100; ++trial) {
        const Vec3 e = random_direction(random);
        const TouchList found = touches(field, c + (grain + 0.498 * d) * e, d / 2, 0.1);
        ASSERT_EQ(found.count, 1);
        EXPECT_FALSE(found.in_trouble());
        EXPECT_NEAR(found.touch[0].gap, -0.002 * d, 0.5 * tolerance * d);
        EXPECT_LT(norm(found.touch[0].normal - e), 5 * tolerance);
        EXPECT_EQ(found.touch[0].share, 1);
      }
    }
  }
}

TEST(DistanceField, sphere_in_a_groove_touches_both_walls_whatever_their_direction) {
  for (const Real d : {8.0, 16.0}) {
    const int n = static_cast<int>(4 * d) + 16;
    for (const Real half_angle : {0.35, 0.7, 1.0, 1.2}) {  // between wall and bisector
      if (0.5 * d / std::tan(half_angle) < 2.3) {
        continue;  // the touch is in the two voxels that the samples round at the corner
      }
      for (const Real turn : {0.0, 0.3, 0.8}) {
        const Vec3 bottom{0.5 * n + 0.123, 0.5 * n - 0.2, 0};
        const Real left = turn + half_angle;
        const Real right = turn - half_angle;
        const Real a1 = left - 1.5707963267948966;  // normals point into the groove
        const Real a2 = right + 1.5707963267948966;
        const auto shape = unite(half_space(bottom, a1), half_space(bottom, a2));
        const auto field = make_field(test::sampled({n, n, 1}, 1, shape), d / 2 + 0.5);
        const Real height = 0.498 * d / std::sin(half_angle);
        const Vec3 c = bottom + height * Vec3{std::cos(turn), std::sin(turn), 0};
        const TouchList found = touches(field, c, d / 2, 0.1);
        ASSERT_EQ(found.count, 2) << d << ' ' << half_angle << ' ' << turn;
        for (const Touch& touch : found.view()) {
          EXPECT_NEAR(touch.gap, -0.002 * d, 2e-4 * d) << half_angle;
          EXPECT_EQ(touch.share, 1);
        }
        EXPECT_NEAR(dot(found.touch[0].normal, found.touch[1].normal), -std::cos(2 * half_angle),
                    1e-2);
      }
    }
  }
}

TEST(DistanceField, sphere_between_grains_touches_each_of_them) {
  constexpr Real d = 8;
  constexpr int n = 60;
  const std::array<Vec3, 3> grain{{{18.2, 20, 30.3}, {42.1, 20.4, 30}, {30.3, 41.6, 29.8}}};
  Distance shape = ball(grain[0], 9);
  shape = unite(shape, unite(ball(grain[1], 9), ball(grain[2], 9)));
  const auto field = make_field(test::sampled({n, n, n}, 1, shape), d / 2 + 1);
  const Vec3 c{30.2, 27.5, 30.1};
  const Real radius = std::min({norm(c - grain[0]), norm(c - grain[1]), norm(c - grain[2])}) - 9;
  const TouchList found = touches(field, c, radius, 0.8);
  ASSERT_EQ(found.count, 3);
  std::array<bool, 3> met{};
  for (const Touch& touch : found.view()) {
    for (std::size_t g = 0; g < 3; ++g) {
      const Vec3 e = (c - grain[g]) / norm(c - grain[g]);
      if (dot(touch.normal, e) > 0.999) {
        met[g] = true;
        EXPECT_NEAR(touch.gap, norm(c - grain[g]) - 9 - radius, 1e-3 * d);
      }
    }
  }
  EXPECT_TRUE(met[0] && met[1] && met[2]);
}

TEST(DistanceField, no_minimum_is_missed_in_rubble) {
  constexpr int n = 56;
  constexpr Real radius = 4;
  const auto field = make_field(test::pictured({n, n, n}, 1, rubble(n, 40, 3)), radius + 1);
  std::mt19937 random(4);
  std::uniform_real_distribution<Real> uniform(2, n - 2.0);
  int compared = 0;
  int free = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const Vec3 c{uniform(random), uniform(random), uniform(random)};
    const Vec3 x = to_voxels(field, c, 1);
    const TouchList found = touches(field, c, radius, 0);
    EXPECT_FALSE(found.uncovered);
    if (found.inside) {
      continue;
    }
    EXPECT_EQ(found.lost, 0);
    Real nearest = radius;  // by descents from every point of the surface around
    field.points.for_each_near(x, radius + 1, [&](std::size_t p) {
      const Foot foot =
          find_foot(field.spline, x, {field.points.x[p], field.points.y[p], field.points.z[p]});
      nearest = foot.found && foot.distance > 0 ? std::min(nearest, foot.distance) : nearest;
      if (foot.found && foot.distance > 0 && foot.distance < radius - 0.2) {
        Real closest = -1;
        for (const Touch& touch : found.view()) {
          closest = std::max(closest, dot(touch.normal, foot.normal));
        }
        EXPECT_GT(closest, 0.9) << "foot at " << foot.distance;
      }
    });
    if (nearest < radius) {
      ASSERT_GT(found.count, 0);
      EXPECT_NEAR(found.touch[0].gap, nearest - radius, 1e-4);
      ++compared;
    } else {
      EXPECT_EQ(found.count, 0);
    }
    free += may_touch(field, x, radius) ? 0 : 1;
  }
  EXPECT_GT(compared, 300);
  EXPECT_GT(free, 50);
}

/// Grains of one to three voxels leave edges sharper than a voxel. Without the descent from the nearest point 2 of
/// 1,000 touching spheres saw nothing of it, or of what they touched deepest.
TEST(DistanceField, no_sphere_overlaps_a_rough_surface_unseen) {
  constexpr int n = 40;
  const auto field = make_field(test::pictured({n, n, n}, 1, rubble(n, 550, 3, 0.8, 3)), 8);
  std::mt19937 random(4);
  std::uniform_real_distribution<Real> uniform(2, n - 2.0);
  int compared = 0;
  for (const Real radius : {2.06, 4.0}) {
    for (int trial = 0; trial < 20'000; ++trial) {
      const Vec3 c{uniform(random), uniform(random), uniform(random)};
      const Vec3 x = to_voxels(field, c, 1);
      const TouchList found = touches(field, c, radius, 0);
      if (found.inside) {
        continue;
      }
      EXPECT_EQ(found.lost, 0);
      Real nearest = radius;
      field.points.for_each_near(x, radius, [&](std::size_t p) {
        const Vec3 at{field.points.x[p], field.points.y[p], field.points.z[p]};
        nearest = std::min(nearest, norm(x - at));
      });
      if (nearest < radius - 0.01) {
        Real deepest = 0;
        for (const Touch& touch : found.view()) {
          deepest = std::min(deepest, touch.gap);
        }
        EXPECT_LT(deepest, nearest - radius + 0.01) << c.x << " " << c.y << " " << c.z;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 20'000);
}

TEST(DistanceField, touches_do_not_depend_on_the_window) {
  constexpr int n = 48;
  const Distance shape = rubble(n, 24, 5);
  const auto whole = test::pictured({n, n, n}, 1, shape);
  geom::VoxelSolid part = whole;
  part.window = {{10, 4, -2}, {40, 40, 33}};
  const Int3 m = part.window.size();
  part.s.clear();
  for (int k = 0; k < m[2]; ++k) {
    for (int j = 0; j < m[1]; ++j) {
      for (int i = 0; i < m[0]; ++i) {
        part.s.push_back(whole.s[static_cast<std::size_t>(
            geom::voxel_index(whole.window.size(), i + 18, j + 12, k + 6))]);
      }
    }
  }
  const auto a = make_field(whole, 5);
  const auto b = make_field(part, 5);
  std::mt19937 random(6);
  std::uniform_real_distribution<Real> uniform(0, 1);
  int met = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Vec3 c{19 + 12 * uniform(random), 13 + 18 * uniform(random), 7 + 17 * uniform(random)};
    const TouchList one = touches(a, c, 4, 0.1);
    const TouchList other = touches(b, c, 4, 0.1);
    ASSERT_FALSE(other.uncovered);
    ASSERT_EQ(one.count, other.count);
    met += one.count;
    for (std::size_t t = 0; t < static_cast<std::size_t>(one.count); ++t) {
      ASSERT_EQ(one.touch[t].gap, other.touch[t].gap);
      ASSERT_EQ(one.touch[t].normal, other.touch[t].normal);
      ASSERT_EQ(one.touch[t].share, other.touch[t].share);
    }
  }
  EXPECT_GT(met, 200);
}

TEST(DistanceField, trouble_is_reported) {
  const auto field =
      make_field(test::sampled({40, 40, 40}, 2, half_space({16.25, 0, 0}, 0)), 10, {1, 0, 0});
  const auto at = [&](Real x, Real y) {
    TouchList out;
    find_touches(field, {1 + x, y, 40}, 8, 0.5, out);
    return out;
  };
  EXPECT_FALSE(at(41, 40).in_trouble());
  EXPECT_EQ(at(41, 40).count, 0);
  ASSERT_EQ(at(40, 40).count, 1);
  EXPECT_NEAR(at(40, 40).touch[0].gap, 40 - 32.5 - 8, 1e-5);
  EXPECT_TRUE(at(32, 40).inside);
  ASSERT_EQ(at(32, 40).count, 1);
  EXPECT_NEAR(at(32, 40).touch[0].normal.x, 1, 1e-6);
  EXPECT_TRUE(at(20, 40).inside);  // more than a radius deep: pushed out all the same
  EXPECT_EQ(at(20, 40).count, 1);
  TouchList point;  // of no size: is it in a grain?
  find_touches(field, {21, 40, 40}, 0, 0, point);
  EXPECT_TRUE(point.inside);
  point.clear();
  find_touches(field, {34.5, 40, 40}, 0, 0, point);
  EXPECT_FALSE(point.inside);
  EXPECT_TRUE(at(40, 9).uncovered);
  EXPECT_TRUE(at(48, -50).uncovered);
}

}  // namespace porefines::dem
