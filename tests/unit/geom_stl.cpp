// SPDX-License-Identifier: MPL-2.0
#include <fstream>
#include <map>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "geom/stl.hpp"
#include "unit/geom_support.hpp"

namespace porefines::geom {

namespace {

constexpr Surroundings mirrored{Beyond::mirror, Beyond::mirror, Beyond::mirror};

VoxelSolid whole(const Voxels& voxels, Real pixel) {
  return smooth_solid(voxels.view(), pixel, mirrored, {{0, 0, 0}, voxels.n}, {1, 4});
}

/// Every directed edge occurs as often as its opposite, and at most `most` times.
void expect_watertight(const std::vector<Triangle>& triangles, int most) {
  using Edge = std::array<std::array<float, 3>, 2>;
  std::map<Edge, int> edges;
  for (const Triangle& t : triangles) {
    for (std::size_t a = 0; a < 3; ++a) {
      ASSERT_NE(t[a], t[(a + 1) % 3]);
      ++edges[{t[a], t[(a + 1) % 3]}];
    }
  }
  for (const auto& [edge, count] : edges) {
    ASSERT_LE(count, most);
    const auto opposite = edges.find({edge[1], edge[0]});
    ASSERT_TRUE(opposite != edges.end());
    ASSERT_EQ(opposite->second, count);
  }
}

Voxels random_discs() {
  std::mt19937 random(4);
  std::vector<Vec3> discs;
  for (int d = 0; d < 40; ++d) {
    discs.push_back({random() % 1600 / 10.0, random() % 1200 / 10.0, 4 + random() % 90 / 10.0});
  }
  return support::rasterise({160, 120, 1}, [&](const Vec3& x) {
    Real s = 100;
    for (const Vec3& d : discs) {
      s = std::min(s, std::hypot(x.x - d.x, x.y - d.y) - d.z);
    }
    return s;
  });
}

Real total_area(const std::vector<Outline>& outlines) {
  Real sum = 0;
  for (const Outline& outline : outlines) {
    sum += signed_area(outline);
  }
  return sum;
}

}  // namespace

TEST(Contours, disc_with_a_hole_has_two_outlines_with_the_right_areas) {
  const Voxels ring = support::rasterise({60, 60, 1}, [](const Vec3& x) {
    const Real r = std::hypot(x.x - 30.2, x.y - 29.7);
    return std::max(r - 20, 9 - r);
  });
  const auto outlines = grain_outlines(whole(ring, 2e-6));
  ASSERT_EQ(outlines.size(), 2U);
  const auto [hole, outer] = std::minmax({signed_area(outlines[0]), signed_area(outlines[1])});
  EXPECT_NEAR(outer / (std::numbers::pi * 1600e-12), 1, 0.005);
  EXPECT_NEAR(hole / (-std::numbers::pi * 324e-12), 1, 0.01);
}

TEST(Contours, grains_at_the_box_face_are_closed_there) {
  const Voxels voxels = support::rasterise({40, 30, 1}, [](const Vec3& x) { return x.x - 10; });
  const auto outlines = grain_outlines(whole(voxels, 1));
  ASSERT_EQ(outlines.size(), 1U);
  EXPECT_NEAR(signed_area(outlines[0]), 300, 1.5);
}

TEST(Contours, simplification_stays_within_its_tolerance_and_saves_points) {
  const auto outlines = grain_outlines(whole(random_discs(), 1));
  const auto simple = simplify(outlines, 0.5);
  ASSERT_EQ(simple.size(), outlines.size());
  std::size_t before = 0;
  std::size_t after = 0;
  for (std::size_t o = 0; o < simple.size(); ++o) {
    before += outlines[o].size();
    after += simple[o].size();
    for (const Point2& p : outlines[o]) {
      Real nearest = 1e9;
      for (std::size_t i = 0; i < simple[o].size(); ++i) {
        const Point2& a = simple[o][i];
        const Point2& b = simple[o][(i + 1) % simple[o].size()];
        for (int step = 0; step <= 100; ++step) {
          const Real t = step / 100.0;
          nearest = std::min(nearest, std::hypot(p[0] - a[0] - t * (b[0] - a[0]),
                                                 p[1] - a[1] - t * (b[1] - a[1])));
        }
      }
      ASSERT_LT(nearest, 0.6);
    }
  }
  EXPECT_LT(4 * after, before);
  EXPECT_NEAR(total_area(simple) / total_area(outlines), 1, 0.02);
}

TEST(Stl, prism_of_many_grains_is_watertight_and_has_the_right_volume) {
  const auto outlines = simplify(grain_outlines(whole(random_discs(), 1e-6)), 0.5e-6);
  const auto triangles = extrude(outlines, 20e-6);
  expect_watertight(triangles, 2);  // a bridge to a hole may be crossed twice
  EXPECT_NEAR(enclosed_volume(triangles) / (total_area(outlines) * 20e-6), 1, 1e-4);
}

TEST(Stl, surface_of_balls_cut_by_the_box_is_watertight_and_has_the_right_volume) {
  const auto distance = [](const Vec3& x) {
    return std::min({norm(x - Vec3{12.3, 14.1, 11.8}) - 8, norm(x - Vec3{30, 15, 14}) - 11,
                     norm(x - Vec3{20, 30, 20}) - 9});
  };
  const Voxels voxels = support::rasterise({34, 36, 28}, distance);
  const auto solid = whole(voxels, 1e-6);
  const auto triangles = grain_surface(solid);
  expect_watertight(triangles, 1);
  Real grain = 0;
  for (const auto p : voxels.pore) {
    grain += 1 - p;
  }
  EXPECT_NEAR(enclosed_volume(triangles) / (grain * 1e-18), 1, 0.01);

  const auto path = support::scratch("stl") / "balls.stl";
  write_stl(path.string(), triangles);
  EXPECT_EQ(std::filesystem::file_size(path), 84 + 50 * triangles.size());
}

TEST(Stl, rough_random_media_are_watertight_too) {
  std::mt19937 random(8);
  Voxels voxels = make_voxels({14, 12, 13}, 0);
  for (auto& p : voxels.pore) {
    p = random() % 2;
  }
  expect_watertight(grain_surface(whole(voxels, 1)), 1);
}

}  // namespace porefines::geom
