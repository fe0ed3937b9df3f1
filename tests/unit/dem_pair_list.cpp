// SPDX-License-Identifier: MPL-2.0
#include <algorithm>

#include <gtest/gtest.h>

#include "dem/exchange.hpp"
#include "dem/pair_list.hpp"
#include "support/spheres.hpp"

namespace porefines::test {

namespace {

using dem::PairList;
using dem::Particles;

/// All pairs with at least one owned particle, by comparing everybody with everybody.
PairList brute_force(const Particles& p, Real skin) {
  PairList all;
  for (std::uint32_t i = 0; i < p.owned; ++i) {
    for (std::uint32_t j = i + 1; j < p.size(); ++j) {
      const Real range = p.radius[i] + p.radius[j] + skin;
      const Vec3 d = p.position[i] - p.position[j];
      if (dot(d, d) < range * range) {
        all.first.push_back(i), all.second.push_back(j);
      }
    }
  }
  return all;
}

/// Spheres anywhere in the unit cube, overlapping or not; radii log-uniform from largest / ratio.
Particles scattered(int count, Real largest, Real ratio) {
  std::mt19937_64 draw(7);
  const auto uniform = [&draw] { return static_cast<Real>(draw() >> 11) * 0x1p-53; };
  Particles p;
  for (int n = 0; n < count; ++n) {
    const Vec3 x{uniform(), uniform(), uniform()};
    p.append(sphere(static_cast<std::uint64_t>(n), x, largest * std::pow(ratio, -uniform()), 1));
  }
  return p;
}

void expect_all_found(const Particles& p, Real skin) {
  PairList found;
  (void)find_pairs(p, skin, found);
  const PairList all = brute_force(p, skin);
  EXPECT_GT(all.size(), 0U);
  EXPECT_EQ(found.first, all.first);
  EXPECT_EQ(found.second, all.second);
}

}  // namespace

TEST(PairList, equal_spheres) {
  expect_all_found(scattered(2000, 0.03, 1), 0.005);
}

TEST(PairList, sizes_one_to_twenty) {
  expect_all_found(scattered(2000, 0.1, 20), 0.004);
}

TEST(PairList, few_in_a_large_box) {
  expect_all_found(scattered(40, 0.05, 50), 0.1);
}

TEST(Blocks, are_columns_where_particles_fall) {
  const dem::Box cube{{0, 0, 0}, {1, 1, 1}, {}};
  EXPECT_EQ(dem::even_blocks(cube, 2).ranks, (Int3{1, 1, 2}));
  EXPECT_EQ(dem::even_blocks(cube, 2, {0, 0, -9.81}).ranks, (Int3{1, 2, 1}));
  EXPECT_EQ(dem::even_blocks(cube, 4, {0, 9.81, 0}).ranks, (Int3{2, 1, 2}));
  const dem::Box hopper{{0, 0, 0}, {1, 1, 10}, {}};
  EXPECT_EQ(dem::even_blocks(hopper, 8, {0, 0, -9.81}).ranks, (Int3{1, 1, 8}));
}

TEST(PairList, ghosts_of_a_periodic_box) {
  for (const Real ratio : {1.0, 20.0}) {
    Particles p = scattered(800, 0.08, ratio);
    const dem::Box box{{0, 0, 0}, {1, 1, 1}, {true, true, true}};
    dem::Exchange exchange(par::Communicator::self(), box, dem::even_blocks(box, 1));
    exchange.make_ghosts(p, 0.01);
    expect_all_found(p, 0.01);
    // Every pair of nearest images is there: count them without ghosts.
    Index images = 0;
    for (std::size_t i = 0; i < p.owned; ++i) {
      for (std::size_t j = i + 1; j < p.owned; ++j) {
        Vec3 d = p.position[i] - p.position[j];
        for (int a = 0; a < 3; ++a) {
          d[a] -= std::round(d[a]);
        }
        images += norm(d) < p.radius[i] + p.radius[j] + 0.01 ? 1 : 0;
      }
    }
    PairList found;
    (void)find_pairs(p, 0.01, found);
    Index halves = 0;
    for (const std::uint32_t j : found.second) {
      halves += j < p.owned ? 2 : 1;
    }
    EXPECT_EQ(halves, 2 * images);
  }
}

TEST(PairList, work_grows_with_the_number_not_its_square) {
  // One large sphere among many small ones, twenty times smaller: distances tried per particle.
  const auto tried_each = [](int count) {
    Particles p = scattered(count, 0.3 / std::cbrt(count), 1);
    p.append(sphere(1u << 30, {0.5, 0.5, 0.5}, 20 * p.radius[0], 1));
    PairList found;
    return static_cast<Real>(find_pairs(p, 0.01 * p.radius[0], found)) / count;
  };
  EXPECT_LT(tried_each(1000), 60);
  EXPECT_LT(tried_each(16000), 60);
}

TEST(PairList, spatial_order_is_a_permutation) {
  const Particles p = scattered(500, 0.05, 3);
  auto order = spatial_order(p, 0.1);
  std::sort(order.begin(), order.end());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    ASSERT_EQ(order[i], i);
  }
}

}  // namespace porefines::test
