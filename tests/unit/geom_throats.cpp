// SPDX-License-Identifier: MPL-2.0
// Throats as short channels: width, section, length, direction, the pores that they join.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>

#include <gtest/gtest.h>

#include "geom/pore_network.hpp"
#include "geom/pore_size.hpp"
#include "unit/geom_support.hpp"

namespace porefines::geom {
namespace {

constexpr Surroundings mirrored{Beyond::mirror, Beyond::mirror, Beyond::mirror};

PoreNetwork network_of(const Voxels& voxels, Real pixel, Real depth = 0,
                       const Surroundings& beyond = mirrored) {
  std::array<bool, 3> periodic{};
  for (std::size_t a = 0; a < 3; ++a) {
    periodic[a] = beyond[a] == Beyond::periodic;
  }
  return find_network(whole_solid(voxels.view(), pixel, beyond, 1), periodic, {0, depth});
}

/// Two chambers of radius 30 joined by a channel of half width `half` from x = 40 to 100 [pixels].
Voxels two_chambers(Real half, Real slope) {
  return support::rasterise({140, 80, 1}, [&](const Vec3& x) {
    const Real y = x.y - 40 - slope * (x.x - 70);
    const Real channel = std::min({half - std::abs(y), x.x - 25, 115 - x.x});
    return std::max({channel, 24 - std::hypot(x.x - 25, x.y - 40 + slope * 45),
                     24 - std::hypot(x.x - 115, x.y - 40 - slope * 45)});
  });
}

}  // namespace

TEST(Throats, gap_between_two_discs_has_the_width_area_and_length_of_its_geometry) {
  const Real r = 30;
  const Real half = 5;
  const Voxels voxels = support::rasterise({120, 80, 1}, [&](const Vec3& x) {
    return std::min(std::hypot(x.x - 60, x.y - 40 + half + r) - r,
                    std::hypot(x.x - 60, x.y - 40 - half - r) - r);
  });
  const PoreNetwork network = network_of(voxels, 1e-6, 20e-6);
  ASSERT_EQ(network.throats.size(), 1U);
  EXPECT_EQ(network.pores.size(), 2U);
  const Throat& t = network.throats[0];
  EXPECT_NEAR(t.centre.x, 60e-6, 1e-6);
  EXPECT_NEAR(t.centre.y, 40e-6, 0.5e-6);
  EXPECT_DOUBLE_EQ(t.centre.z, 10e-6);
  EXPECT_NEAR(t.width, 10e-6, 0.3e-6);
  EXPECT_DOUBLE_EQ(t.area, t.width * 20e-6);
  EXPECT_NEAR(t.normal.x, 1, 0.01);
  // the gap 2 (half + r - sqrt(r^2 - x^2)) is 5/4 of its smallest at x = 8.57
  const Real reach = std::sqrt(r * r - std::pow(r - 0.25 * half, 2)) * 1e-6;
  EXPECT_NEAR(t.behind + t.ahead, 2 * reach, 2.5e-6);
  EXPECT_LT(network.pores[static_cast<std::size_t>(t.pore_behind)].centre.x, t.centre.x);
  EXPECT_GT(network.pores[static_cast<std::size_t>(t.pore_ahead)].centre.x, t.centre.x);
}

TEST(Throats, slanted_channel_reaches_from_chamber_to_chamber) {
  for (const Real slope : {0.0, 0.3}) {
    const PoreNetwork network = network_of(two_chambers(4, slope), 2e-6, 20e-6);
    ASSERT_EQ(network.throats.size(), 1U) << slope;
    const Throat& t = network.throats[0];
    const Real cosine = 1 / std::hypot(1, slope);
    EXPECT_NEAR(t.width, 8 * cosine * 2e-6, 0.4 * 2e-6) << slope;
    EXPECT_NEAR(t.normal.x, cosine, 0.02) << slope;
    EXPECT_NEAR(t.normal.y, slope * cosine, 0.07) << slope;
    EXPECT_NEAR(t.centre.x, 70 * 2e-6, 3 * 2e-6) << slope;
    // along its axis it ends where the chambers begin, 66 - 24 pixels apart at least
    EXPECT_GT((t.behind + t.ahead) / 2e-6, 36) << slope;
    EXPECT_LT((t.behind + t.ahead) / 2e-6, 52 / cosine) << slope;
  }
}

TEST(Throats, neck_with_an_elliptic_section_has_its_short_axis_as_width_and_its_area) {
  const Real a = 5;   // along y
  const Real b = 11;  // along z
  const Voxels voxels = support::rasterise({70, 40, 40}, [&](const Vec3& x) {
    const Real neck =
        std::min(1 - std::hypot((x.y - 20) / a, (x.z - 20) / b), std::min(x.x - 17, 53 - x.x) / 20);
    return std::max(
        {neck, (15 - norm(x - Vec3{17, 20, 20})) / 15, (15 - norm(x - Vec3{53, 20, 20})) / 15});
  });
  const PoreNetwork network = network_of(voxels, 1e-6);
  ASSERT_EQ(network.throats.size(), 1U);
  const Throat& t = network.throats[0];
  EXPECT_NEAR(t.width, 2 * a * 1e-6, 0.5e-6);
  EXPECT_NEAR(std::abs(t.across.y), 1, 0.02);
  EXPECT_NEAR(t.normal.x, 1, 0.02);
  EXPECT_NEAR(t.area / (std::numbers::pi * a * b * 1e-12), 1, 0.05);
  EXPECT_FALSE(network.flat);
}

TEST(Throats, of_a_periodic_lattice_lie_in_the_box_in_order_of_x_and_join_two_pores_each) {
  const Voxels voxels = support::rasterise({120, 120, 1}, [](const Vec3& x) {
    return std::hypot(std::fmod(x.x, 40) - 20, std::fmod(x.y, 40) - 20) - 15;
  });
  const PoreNetwork network =
      network_of(voxels, 1e-6, 0, {Beyond::periodic, Beyond::periodic, Beyond::periodic});
  ASSERT_EQ(network.throats.size(), 18U);
  EXPECT_EQ(network.pores.size(), 9U);
  for (std::size_t i = 0; i < network.throats.size(); ++i) {
    const Throat& t = network.throats[i];
    EXPECT_TRUE(i == 0 || network.throats[i - 1].centre.x <= t.centre.x);
    EXPECT_TRUE(t.centre.x >= 0 && t.centre.x < 120e-6 && t.centre.y >= 0 && t.centre.y < 120e-6);
    EXPECT_NE(t.pore_behind, t.pore_ahead);
    EXPECT_NEAR(t.width, 10e-6, 1e-6);
  }
}

TEST(Throats, of_a_list_of_cylinders_are_measured_on_the_list) {
  Sample sample;
  sample.spec.kind = Kind::cylinders;
  sample.box = {{120e-6, 80e-6, 15e-6}, mirrored};
  sample.bodies = {{{60e-6, 5e-6, 0}, 30e-6}, {{60e-6, 75e-6, 0}, 30e-6}};
  const PoreNetwork network = find_network(sample, 0);
  ASSERT_EQ(network.throats.size(), 1U);
  EXPECT_NEAR(network.throats[0].width, 10e-6, 0.02e-6);  // its voxels are 0.6 um
  EXPECT_NEAR(network.throats[0].centre.x, 60e-6, 0.6e-6);
  EXPECT_DOUBLE_EQ(network.throats[0].centre.z, 7.5e-6);
  EXPECT_TRUE(network.flat);
  const PoreNetwork shared = share_network(network, MPI_COMM_SELF);
  EXPECT_EQ(shared.throats[0].centre, network.throats[0].centre);
  const auto folder = support::scratch("throats");
  write_throats((folder / "throats.csv").string(), network.throats);
  std::ifstream file(folder / "throats.csv");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(text.rfind("id,x_m,y_m,z_m,width_m,area_m2,", 0), 0U);
  EXPECT_NE(text.find("\n0,"), std::string::npos);
}

TEST(Throats, at_a_side_that_is_a_wall_are_as_wide_as_the_gap) {
  const Voxels voxels = support::rasterise(
      {120, 60, 1}, [](const Vec3& x) { return std::hypot(x.x - 60, x.y - 34) - 26; });
  const VoxelSolid solid = whole_solid(voxels.view(), 1, mirrored, 1);
  for (const bool wall : {true, false}) {
    const PoreNetwork network = find_network(solid, {}, {0, 1, {false, wall, false}, {}});
    const auto low = std::find_if(network.throats.begin(), network.throats.end(),
                                  [](const Throat& t) { return t.centre.y < 10; });
    ASSERT_NE(low, network.throats.end());
    EXPECT_NEAR(low->width, wall ? 8 : 16, 0.6);
    EXPECT_NEAR(low->centre.y, wall ? 4 : 0, 0.4);
  }
}

TEST(Throats, of_a_volume_between_plates_end_at_the_plates) {
  const Voxels voxels = support::rasterise({80, 60, 14}, [](const Vec3& x) {
    return std::min(std::hypot(x.x - 40, x.y - 5) - 20, std::hypot(x.x - 40, x.y - 55) - 20);
  });
  const VoxelSolid solid = whole_solid(voxels.view(), 1, mirrored, 1);
  const PoreNetwork network = find_network(solid, {}, {0, 0, {false, true, true}, {}});
  const auto middle = std::find_if(network.throats.begin(), network.throats.end(),
                                   [](const Throat& t) { return std::abs(t.centre.y - 30) < 3; });
  ASSERT_NE(middle, network.throats.end());
  EXPECT_NEAR(middle->width, 10, 0.7);
  EXPECT_NEAR(middle->area, 10 * 14, 0.07 * 140);
}

TEST(Throats, between_three_touching_spheres_have_the_area_of_the_gap) {
  // a triangle of spheres of radius r in the plane x = 0, walls away: gap sqrt(3) r^2 - pi/2 r^2
  Sample sample;
  sample.spec.kind = Kind::spheres;
  sample.box = {{60e-6, 60e-6, 60e-6}, mirrored};
  const Real r = 15e-6;
  const Real h = std::sqrt(3.0) * r;
  sample.bodies = {{{30e-6, 30e-6 - h / 3, 15e-6}, r},
                   {{30e-6, 30e-6 - h / 3, 45e-6}, r},
                   {{30e-6, 30e-6 + 2 * h / 3, 30e-6}, r}};
  const PoreNetwork network = find_network(sample, 0.6e-6);
  const auto throat =
      std::find_if(network.throats.begin(), network.throats.end(), [](const Throat& t) {
        return norm(t.centre - Vec3{30e-6, 30e-6, 30e-6}) < 3e-6;
      });
  ASSERT_NE(throat, network.throats.end());
  EXPECT_NEAR(throat->normal.x, 1, 0.03);
  EXPECT_NEAR(throat->area / ((std::sqrt(3.0) - std::numbers::pi / 2) * r * r), 1, 0.05);
}

}  // namespace porefines::geom
