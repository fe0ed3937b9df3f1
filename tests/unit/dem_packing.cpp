// SPDX-License-Identifier: MPL-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/random.hpp"
#include "dem/packing.hpp"

namespace porefines::dem {
namespace {

/// Largest overlap over the mean diameter of the pair: every pair is looked at.
Real largest_overlap(const Packing& packing, const PackingSpace& space) {
  Real worst = 0;
  for (std::size_t i = 0; i < packing.position.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      Vec3 d = packing.position[i] - packing.position[j];
      for (int a = 0; a < 3; ++a) {
        const Real edge = space.high[a] - space.low[a];
        d[a] -= space.periodic[a] ? edge * std::round(d[a] / edge) : 0;
      }
      worst = std::max(worst, 1 - norm(d) / (packing.radius[i] + packing.radius[j]));
    }
  }
  return worst;
}

/// Largest depth in the walls of the space, over the diameter.
Real largest_depth(const Packing& packing, const PackingSpace& space) {
  Real worst = 0;
  for (std::size_t i = 0; i < packing.position.size(); ++i) {
    const Real r = packing.radius[i];
    for (int a = 0; a < 3; ++a) {
      if (!space.periodic[a]) {
        const Real x = packing.position[i][a];
        worst =
            std::max({worst, (space.low[a] + r - x) / (2 * r), (x + r - space.high[a]) / (2 * r)});
      }
    }
  }
  return worst;
}

Real fraction(const Packing& packing, const PackingSpace& space) {
  return sphere_volume(packing.radius) / space.volume();
}

/// A third of the radii 1, 2 and 3 times the smallest.
std::vector<Real> three_sizes(std::size_t count) {
  std::vector<Real> radius;
  for (std::size_t i = 0; i < count; ++i) {
    radius.push_back(1e-5 * static_cast<Real>(1 + i % 3));
  }
  return radius;
}

const PackingSpace periodic_cube{{0, 0, 0}, {1e-3, 1e-3, 1e-3}, {true, true, true}};

TEST(DemPacking, equal_spheres_jam_at_random_close_packing) {
  const Packing packing = pack_dense(periodic_cube, std::vector<Real>(600, 50e-6));
  // 600 spheres: finite size lowers and blurs the density, 0.64 +- 0.01.
  EXPECT_GT(fraction(packing, periodic_cube), 0.62);
  EXPECT_LT(fraction(packing, periodic_cube), 0.655);
  EXPECT_LT(packing.mean_overlap, 1e-3);
  EXPECT_GT(packing.mean_overlap, 0);
  EXPECT_LT(largest_overlap(packing, periodic_cube), 5e-3);
  // Isostatic: 6 contacts per sphere that is no rattler, and a few more above jamming.
  EXPECT_GT(packing.contacts, 5.5);
  EXPECT_LT(packing.contacts, 6.5);
}

TEST(DemPacking, is_the_same_for_the_same_seed_and_another_for_another) {
  PackingSpace space = periodic_cube;
  const std::vector<Real> radius(60, 50e-6);
  const Packing one = pack_dense(space, radius);
  EXPECT_EQ(one.position, pack_dense(space, radius).position);
  space.seed = 2;
  EXPECT_NE(one.position, pack_dense(space, radius).position);
}

TEST(DemPacking, keeps_the_ratios_of_sizes_between_walls) {
  PackingSpace space{{-1e-3, 0, 0}, {0, 1e-3, 0.5e-3}, {true, false, false}};
  const Packing packing = pack_dense(space, three_sizes(300));
  EXPECT_LT(largest_overlap(packing, space), 5e-3);
  EXPECT_LT(largest_depth(packing, space), 5e-3);
  EXPECT_GT(fraction(packing, space), 0.55);
  EXPECT_NEAR(packing.radius[1] / packing.radius[0], 2, 1e-12);
  EXPECT_NEAR(packing.radius[2] / packing.radius[0], 3, 1e-12);
  EXPECT_NEAR(packing.radius[0], packing.scale * 1e-5, 1e-17);
}

TEST(DemPacking, loose_spheres_do_not_touch) {
  PackingSpace space{{0, 0, 0}, {1e-3, 1e-3, 1e-3}, {false, true, false}};
  std::vector<Real> radius = three_sizes(900);
  const Real scale = std::cbrt(0.45 * space.volume() / sphere_volume(radius));
  for (Real& r : radius) {
    r *= scale;
  }
  const Packing packing = place_loose(space, radius);
  EXPECT_EQ(packing.radius, radius);
  EXPECT_LE(largest_overlap(packing, space), 0);
  EXPECT_LE(largest_depth(packing, space), 0);
}

TEST(DemPacking, surfaces_keep_spheres_out) {
  const Ball bowl{{0.5e-3, 0.5e-3, 0.5e-3}, 0.5e-3, true, {}};
  const Surfaces surfaces{Primitives{bowl}};
  PackingSpace space{{0, 0, 0}, {1e-3, 1e-3, 1e-3}};
  space.surfaces = &surfaces;
  const Packing packing = place_loose(space, std::vector<Real>(100, 50e-6));  // a fifth of the bowl
  for (const Vec3& x : packing.position) {
    EXPECT_LE(norm(x - bowl.centre) + 50e-6, bowl.radius);
  }
}

TEST(DemPacking, says_what_does_not_fit) {
  EXPECT_THROW((void)place_loose(periodic_cube, std::vector<Real>(10, 0.6e-3)), InputError);
  EXPECT_THROW((void)place_loose(periodic_cube, std::vector<Real>(60, 150e-6)), InputError);
  EXPECT_THROW((void)pack_dense(periodic_cube, {}), InputError);
}

}  // namespace
}  // namespace porefines::dem
