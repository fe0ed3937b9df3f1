// SPDX-License-Identifier: MPL-2.0
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "dem/surface.hpp"

namespace porefines::dem {

namespace {

using geom::Beyond;

template <int dims>
Surfaces grains(const std::vector<geom::Body>& bodies, const geom::SampleBox& box, Real band,
                const Vec3& corner = {}) {
  return {Fixed(RoundGrains<dims>{geom::RoundBodies<dims>(bodies, box, true, band), corner})};
}

}  // namespace

TEST(RoundGrains, every_grain_in_reach_touches_once_as_in_brute_force) {
  std::mt19937 random(1);
  std::uniform_real_distribution<Real> uniform(0, 1);
  std::vector<geom::Body> bodies;
  for (int b = 0; b < 120; ++b) {
    bodies.push_back(
        {{uniform(random), uniform(random), uniform(random)}, 0.03 + 0.05 * uniform(random)});
  }
  const geom::SampleBox box{{1, 1, 1}, {Beyond::periodic, Beyond::pore, Beyond::periodic}};
  const Vec3 corner{-0.3, 0.2, 0};
  const Surfaces surfaces = grains<3>(bodies, box, 0.06, corner);
  Index met = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const Vec3 x{uniform(random), uniform(random), uniform(random)};
    TouchList found;
    find_touches(surfaces, x + corner, 0.05, 0.01, found);
    EXPECT_FALSE(found.uncovered);
    Index expected = 0;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      for (const Real sx : {-1, 0, 1}) {
        for (const Real sz : {-1, 0, 1}) {
          const Vec3 d = x - bodies[b].centre - Vec3{sx, 0, sz};
          const Real gap = norm(d) - bodies[b].radius - 0.05;
          if (gap >= 0.01) {
            continue;
          }
          ++expected;
          const auto match = [&](const Touch& t) {
            return t.feature == b && std::abs(t.gap - gap) < 1e-14 &&
                   dot(t.normal, d) > 0.999999 * norm(d) &&
                   std::abs(t.curvature * bodies[b].radius - 1) < 1e-12;
          };
          const auto view = found.view();
          EXPECT_EQ(std::count_if(view.begin(), view.end(), match), 1);
        }
      }
    }
    EXPECT_EQ(found.count + found.lost, expected);
    met += expected;
  }
  EXPECT_GT(met, 1000);
}

TEST(RoundGrains, cylinders_have_no_ends_and_half_the_curvature) {
  const geom::SampleBox box{{10, 10, 4}, {Beyond::mirror, Beyond::mirror, Beyond::mirror}};
  const Surfaces surfaces = grains<2>({{{3, 5, 0}, 2}, {{8, 5, 0}, 1.5}}, box, 1);
  TouchList found;
  find_touches(surfaces, {5.75, 5, 77}, 0.77, 0, found);
  ASSERT_EQ(found.count, 2);
  EXPECT_NEAR(found.touch[0].gap, -0.02, 1e-12);
  EXPECT_NEAR(found.touch[0].curvature, 0.25, 1e-15);
  EXPECT_NEAR(found.touch[0].normal.x, 1, 1e-15);
  EXPECT_NEAR(found.touch[1].gap, -0.02, 1e-12);
  EXPECT_NEAR(found.touch[1].normal.x, -1, 1e-15);
  find_touches(surfaces, {-5.75, 5, 1}, 0.77, 0, found);  // beyond the mirror at x = 0
  ASSERT_EQ(found.count, 2);
  EXPECT_NEAR(found.touch[0].normal.x, -1, 1e-15);
  find_touches(surfaces, {5.75, 5, 1}, 1.5, 0, found);
  EXPECT_TRUE(found.uncovered);  // larger than the list was built for
  find_touches(surfaces, {3, 6, 1}, 0.5, 0, found);
  EXPECT_TRUE(found.inside);
}

TEST(RoundGrains, copies_of_a_surface_share_the_grains) {
  const geom::SampleBox box{{1, 1, 1}, {Beyond::pore, Beyond::pore, Beyond::pore}};
  const Surfaces one = grains<3>({{{0.5, 0.5, 0.5}, 0.1}}, box, 0.1);
  const Surfaces copy = one;
  EXPECT_EQ(std::get<Fixed<RoundGrains<3>>>(one[0]).grains.get(),
            std::get<Fixed<RoundGrains<3>>>(copy[0]).grains.get());
}

}  // namespace porefines::dem
