// SPDX-License-Identifier: MPL-2.0
#include <random>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "geom/clean.hpp"
#include "geom/throat_opening.hpp"
#include "geom/voxel_solid.hpp"
#include "unit/geom_support.hpp"

namespace porefines::geom {

namespace {

constexpr std::array<bool, 3> closed{false, false, false};

Index count_pores(const Voxels& voxels) {
  Index sum = 0;
  for (const auto p : voxels.pore) {
    sum += p;
  }
  return sum;
}

/// Components by flood fill, as a reference.
int count_by_flooding(const Voxels& voxels, bool pore, const std::array<bool, 3>& periodic) {
  const Int3 n = voxels.n;
  std::vector<std::uint8_t> seen(voxels.pore.size(), 0);
  int count = 0;
  for (Index start = 0; start < product(n); ++start) {
    if (seen[static_cast<std::size_t>(start)] != 0 ||
        (voxels.pore[static_cast<std::size_t>(start)] != 0) != pore) {
      continue;
    }
    ++count;
    std::vector<Index> stack{start};
    seen[static_cast<std::size_t>(start)] = 1;
    while (!stack.empty()) {
      const Index v = stack.back();
      stack.pop_back();
      for (int a = 0; a < 27; ++a) {
        const Int3 step{a % 3 - 1, a / 3 % 3 - 1, a / 9 - 1};
        if (pore && std::abs(step[0]) + std::abs(step[1]) + std::abs(step[2]) != 1) {
          continue;
        }
        Int3 x{static_cast<int>(v % n[0]), static_cast<int>(v / n[0] % n[1]),
               static_cast<int>(v / n[0] / n[1])};
        bool inside = true;
        for (std::size_t t = 0; t < 3; ++t) {
          x[t] += step[t];
          inside = inside && (periodic[t] || (x[t] >= 0 && x[t] < n[t]));
          x[t] = (x[t] + n[t]) % n[t];
        }
        const auto u = static_cast<std::size_t>(voxel_index(n, x[0], x[1], x[2]));
        if (inside && seen[u] == 0 && (voxels.pore[u] != 0) == pore) {
          seen[u] = 1;
          stack.push_back(static_cast<Index>(u));
        }
      }
    }
  }
  return count;
}

/// Width of the pore at (x, y) along y, from the smooth surface [pixels].
Real width_along_y(const Voxels& voxels, Real x) {
  const auto solid =
      smooth_solid(voxels.view(), 1, {Beyond::mirror, Beyond::mirror, Beyond::mirror},
                   {{0, 0, 0}, voxels.n}, {1, 4});
  Real width = 0;
  for (Real y = 0; y < voxels.n[1]; y += 0.01) {
    width += signed_distance(solid, {x, y, 0}) > 0 ? 0.01 : 0;
  }
  return width;
}

}  // namespace

TEST(Components, agree_with_flood_fill_on_random_media) {
  std::mt19937 random(11);
  for (const auto& periodic :
       {closed, std::array<bool, 3>{true, false, true}, std::array<bool, 3>{true, true, true}}) {
    for (const Int3& n : {Int3{13, 11, 9}, Int3{31, 27, 1}}) {
      Voxels voxels = make_voxels(n, 0);
      for (auto& p : voxels.pore) {
        p = random() % 100 < 38 ? 1 : 0;
      }
      for (const Phase phase : {Phase::pore, Phase::grain}) {
        const auto found = find_components(voxels.view(), phase, periodic, 0);
        EXPECT_EQ(static_cast<int>(found.component.size()),
                  count_by_flooding(voxels, phase == Phase::pore, periodic));
        Index sum = 0;
        for (const Component& part : found.component) {
          sum += part.voxels;
        }
        const Index pores = count_pores(voxels);
        EXPECT_EQ(sum, phase == Phase::pore ? pores : product(n) - pores);
      }
    }
  }
}

TEST(Clean, islands_and_specks_vanish_and_larger_ones_stay) {
  Voxels voxels = support::from_picture({"..........",  //
                                         ".#....##..",  //
                                         "......##..",  //
                                         "..........",  //
                                         "##########",  //
                                         "###.##..##",  //
                                         "##########"});
  EXPECT_EQ(remove_small(voxels, Phase::grain, 2, closed), 1);
  EXPECT_EQ(remove_small(voxels, Phase::pore, 2, closed), 1);
  EXPECT_TRUE(voxels.at(1, 5, 0));
  EXPECT_FALSE(voxels.at(6, 5, 0));
  EXPECT_FALSE(voxels.at(3, 1, 0));
  EXPECT_TRUE(voxels.at(6, 1, 0));
}

TEST(Clean, keeps_what_connects_the_faces_and_drops_dead_pores) {
  Voxels voxels = support::from_picture({"....######",  // touches x- only
                                         "##########",  //
                                         "..........",  // carries flow
                                         "##########",  //
                                         "##..######"});
  Voxels none = voxels;
  EXPECT_EQ(keep_percolating(voxels, closed, 0, "image"), 6);
  EXPECT_EQ(count_pores(voxels), 10);
  EXPECT_THROW((void)keep_percolating(none, closed, 1, "image"), InputError);
}

TEST(Clean, around_a_period_a_pore_must_close_on_itself) {
  // the diagonal channel touches x- and x+, but at different heights: no way around the period
  const std::vector<std::string> rows{"..........",  //
                                      ".########.",  //
                                      "##########",  //
                                      "..####....",  //
                                      "#.####.###",  //
                                      "#......###"};
  const auto make = [&] { return support::from_picture(rows); };
  const std::array<bool, 3> x_periodic{true, false, false};
  const auto parts = find_components(make().view(), Phase::pore, x_periodic, 0);
  ASSERT_EQ(parts.component.size(), 2U);
  EXPECT_TRUE(parts.component[0].wraps);
  EXPECT_TRUE(parts.component[1].wraps);
  Voxels shifted = make();
  for (int i = 6; i < 10; ++i) {  // block the lower channel on the right
    shifted.at(i, 2, 0) = 0;
  }
  EXPECT_EQ(keep_percolating(shifted, x_periodic, 0, "image"), 10);
  Voxels stairs = support::from_picture({"...###", "##.###", "##....", "######"});
  EXPECT_EQ(find_components(stairs.view(), Phase::pore, closed, 0).component[0].touches_high, true);
  EXPECT_THROW((void)keep_percolating(stairs, x_periodic, 0, "image"), InputError);
}

TEST(Clean, thin_walls_between_separate_pores_open_only_when_asked) {
  Voxels voxels = support::from_picture({"....##....", "....##....", "....##...."});
  EXPECT_EQ(reconnect(voxels, 0, closed), 0);
  EXPECT_EQ(reconnect(voxels, 1, closed), 0);
  EXPECT_EQ(reconnect(voxels, 2, closed), 6);
  Voxels loop = support::from_picture({"..........", "....##....", "....##...."});
  EXPECT_EQ(reconnect(loop, 2, closed), 0);  // the two sides are one pore already
}

TEST(ThroatOpening, reaches_the_width_asked_for_and_leaves_the_rest) {
  for (const int width : {3, 4, 5, 8}) {
    for (const int narrow : {1, 2, 3}) {
      Voxels voxels = support::rasterise({80, 41, 1}, [&](const Vec3& x) {
        const Real half = x.x < 30 || x.x > 50 ? 14 : 0.5 * narrow;
        return half - std::abs(x.y - 20.5 + (narrow == 2 ? 0.5 : 0));
      });
      const Voxels before = voxels;
      const Index opened =
          open_throats(voxels, width, {Beyond::mirror, Beyond::mirror, Beyond::mirror});
      EXPECT_EQ(opened > 0, narrow < width);
      EXPECT_GE(width_along_y(voxels, 40.5), std::max(width, narrow) - 0.1);
      EXPECT_LE(width_along_y(voxels, 40.5), std::max(width, narrow) + 1.1);
      for (int i = 0; i < 80; ++i) {
        for (int j = 0; j < 41; ++j) {
          if (std::abs(i - 39.5) > 10 + 0.5 * width) {
            ASSERT_EQ(voxels.at(i, j, 0), before.at(i, j, 0));
          }
        }
      }
    }
  }
}

TEST(ThroatOpening, cusps_between_touching_grains_stay) {
  Voxels voxels = support::rasterise({60, 60, 1}, [](const Vec3& x) {
    return std::min(norm(x - Vec3{18, 30, 0.5}) - 12, norm(x - Vec3{42, 30, 0.5}) - 12.2);
  });
  EXPECT_EQ(open_throats(voxels, 5, {Beyond::mirror, Beyond::mirror, Beyond::mirror}), 0);
}

TEST(ThroatOpening, works_in_3d) {
  Voxels voxels = support::rasterise({40, 21, 21}, [](const Vec3& x) {
    const Real radius = x.x < 14 || x.x > 26 ? 9 : 1.2;
    return radius - std::hypot(x.y - 10.5, x.z - 10.5);
  });
  EXPECT_GT(open_throats(voxels, 6, {Beyond::mirror, Beyond::mirror, Beyond::mirror}), 100);
  for (int d = -2; d <= 2; ++d) {
    EXPECT_TRUE(voxels.at(20, 10 + d, 10));
    EXPECT_TRUE(voxels.at(20, 10, 10 + d));
  }
  EXPECT_FALSE(voxels.at(20, 15, 10));
}

}  // namespace porefines::geom
