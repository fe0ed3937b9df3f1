// SPDX-License-Identifier: MPL-2.0
#include <random>

#include <gtest/gtest.h>

#include "geom/blur.hpp"
#include "geom/nearest.hpp"
#include "geom/simple_point.hpp"
#include "geom/voxels.hpp"

namespace porefines::geom {

namespace {

/// Compare with brute force over all marks within reach.
void compare(const Int3& n, int reach, int one_in) {
  std::mt19937 random(7);
  std::vector<std::uint8_t> mark(static_cast<std::size_t>(product(n)));
  for (auto& m : mark) {
    m = random() % static_cast<unsigned>(one_in) == 0 ? 1 : 0;
  }
  const int rz = n[2] == 1 ? 0 : reach;
  int rows = 0;
  for_each_nearest(mark, n, reach, [&](int j, int k, const std::vector<Offset>& row) {
    ++rows;
    for (int i = 0; i < static_cast<int>(row.size()); ++i) {
      int best = INT32_MAX;
      for (int c = -rz; c <= rz; ++c) {
        for (int b = -reach; b <= reach; ++b) {
          for (int a = -reach; a <= reach; ++a) {
            const Index at =
                i + reach + a + Index{n[0]} * (j + reach + b + Index{n[1]} * (k + rz + c));
            if (mark[static_cast<std::size_t>(at)] != 0) {
              best = std::min(best, a * a + b * b + c * c);
            }
          }
        }
      }
      const Offset& o = row[static_cast<std::size_t>(i)];
      if (best == INT32_MAX) {
        ASSERT_EQ(o.dx, Offset::nothing);
        continue;
      }
      ASSERT_EQ(o.dx * o.dx + o.dy * o.dy + o.dz * o.dz, best);
      const Index at =
          i + reach + o.dx + Index{n[0]} * (j + reach + o.dy + Index{n[1]} * (k + rz + o.dz));
      ASSERT_EQ(mark[static_cast<std::size_t>(at)], 1);
    }
  });
  EXPECT_EQ(rows, (n[1] - 2 * reach) * (n[2] - 2 * rz));
}

}  // namespace

TEST(Nearest, equals_brute_force_in_3d) {
  compare({19, 17, 16}, 5, 60);
}
TEST(Nearest, equals_brute_force_in_2d_with_long_reach) {
  compare({93, 90, 1}, 40, 900);
}
TEST(Nearest, finds_nothing_where_nothing_is_marked) {
  compare({12, 12, 1}, 3, 1 << 30);
}

TEST(Blur, weights_add_up_and_the_edge_of_a_half_plane_is_one_half) {
  const auto weights = gaussian_weights(1.3);
  int sum = 0;
  for (const int w : weights) {
    sum += w;
  }
  EXPECT_EQ(sum, blur_one);
  Int3 n{24, static_cast<int>(weights.size()), 1};
  std::vector<std::uint8_t> share(static_cast<std::size_t>(product(n)));
  for (std::size_t v = 0; v < share.size(); ++v) {
    share[v] = v % 24 >= 12 ? full_share : std::uint8_t{0};
  }
  const auto phi = blur(share, n, weights);
  ASSERT_EQ(n[1], 1);
  const auto middle = static_cast<std::size_t>(12 - static_cast<int>(weights.size()) / 2);
  EXPECT_EQ(phi[middle - 1] + phi[middle], blur_one);  // odd about the edge
  EXPECT_NEAR(phi[middle] / static_cast<Real>(blur_one), 0.5 * std::erfc(-0.5 / 1.3 / std::sqrt(2)),
              0.005);
}

TEST(SimplePoint, knows_ends_bridges_and_interiors) {
  const auto flat = [](std::array<int, 9> pore) {
    Neighbourhood around{};
    for (std::size_t v = 0; v < 9; ++v) {
      around[9 + v] = static_cast<std::uint8_t>(pore[v]);
    }
    return is_simple(around, true);
  };
  EXPECT_TRUE(flat({0, 0, 0, 1, 1, 0, 0, 0, 0}));   // end of a channel
  EXPECT_FALSE(flat({0, 0, 0, 1, 1, 1, 0, 0, 0}));  // channel one pixel wide
  EXPECT_FALSE(flat({0, 0, 0, 0, 1, 0, 0, 0, 0}));  // lonely pore
  EXPECT_FALSE(flat({1, 1, 1, 1, 1, 1, 1, 1, 1}));  // inside of a pore
  EXPECT_TRUE(flat({1, 1, 1, 1, 1, 1, 0, 0, 0}));   // on a straight edge
  EXPECT_FALSE(flat({0, 1, 1, 1, 0, 1, 1, 1, 0}));  // grain pixel between diagonal grains
  Neighbourhood solid{};
  EXPECT_FALSE(is_simple(solid, false));
  solid[12] = 1;
  EXPECT_TRUE(is_simple(solid, false));
  solid[14] = 1;
  EXPECT_FALSE(is_simple(solid, false));  // bridge along x
}

}  // namespace porefines::geom
