// SPDX-License-Identifier: MPL-2.0
#include <numbers>

#include <gtest/gtest.h>

#include "geom/metrics.hpp"
#include "geom/pore_size.hpp"
#include "unit/geom_support.hpp"

namespace porefines::geom {

namespace {

constexpr Surroundings mirrored{Beyond::mirror, Beyond::mirror, Beyond::mirror};
constexpr Surroundings periodic{Beyond::periodic, Beyond::periodic, Beyond::periodic};

/// Square lattice of discs, `pitch` apart: throats of width pitch - 2 r between neighbours.
Voxels disc_lattice(int cells, Real pitch, Real r) {
  const int n = static_cast<int>(std::lround(cells * pitch));
  return support::rasterise({n, n, 1}, [&](const Vec3& x) {
    const Real dx = std::fmod(x.x, pitch) - 0.5 * pitch;
    const Real dy = std::fmod(x.y, pitch) - 0.5 * pitch;
    return std::hypot(dx, dy) - r;
  });
}

}  // namespace

TEST(Metrics, lattice_of_discs_has_its_throats_pores_and_grains) {
  const Voxels voxels = disc_lattice(6, 40, 15.3);
  Question question;
  question.fine_diameter = 10e-6;
  question.cell_size = 3e-6;
  question.depth = 20e-6;
  const Metrics m = measure(voxels.view(), 2e-6, periodic, question);
  const Real disc = std::numbers::pi * 15.3 * 15.3;
  EXPECT_NEAR(m.porosity, 1 - disc / 1600, 3e-3);
  EXPECT_NEAR(m.porosity_connected, m.porosity, 1e-12);
  EXPECT_NEAR(m.porosity_smooth, m.porosity, 1e-3);
  EXPECT_NEAR(m.specific_surface / (2 * std::numbers::pi * 15.3 / 1600 / 2e-6), 1, 0.02);
  EXPECT_EQ(m.throats.size(), 72U);  // two per disc
  EXPECT_NEAR(m.throat_widths.mean(), 9.4 * 2e-6, 0.65 * 2e-6);
  EXPECT_NEAR(m.throat_widths.quantile(0), m.throat_widths.quantile(1), 0.5 * 2e-6);
  EXPECT_EQ(m.grains.size.size(), 36U);
  EXPECT_NEAR(m.grains.quantile(0.5), 30.6 * 2e-6, 0.5 * 2e-6);
  EXPECT_NEAR(m.pores.quantile(1), 2 * (20 * std::numbers::sqrt2 - 15.3) * 2e-6, 1 * 2e-6);
  EXPECT_EQ(m.throats_under_4_cells, 0);
  const std::string json = to_json(m, question).text();
  EXPECT_NE(json.find("\"throat_to_fine_ratio_mean\": 1.9"), std::string::npos) << json;
  question.cell_size = 6e-6;
  EXPECT_EQ(measure(voxels.view(), 2e-6, periodic, question).throats_under_4_cells, 1);
}

TEST(Metrics, throat_lies_where_the_grains_come_closest) {
  const Voxels voxels = support::rasterise({120, 60, 1}, [](const Vec3& x) {
    return std::min(std::hypot(x.x - 60, x.y - 10) - 22, std::hypot(x.x - 60, x.y - 58) - 18);
  });
  const Metrics m = measure(voxels.view(), 1, mirrored, {});
  ASSERT_EQ(m.throats.size(), 1U);
  EXPECT_NEAR(m.throats[0].centre.x, 60, 3);
  EXPECT_NEAR(m.throats[0].centre.y, 36, 1);
  EXPECT_NEAR(m.throats[0].width, 8, 0.3);
  EXPECT_NEAR(std::abs(m.throats[0].across.y), 1, 0.02);
}

TEST(Metrics, surface_of_a_sphere_is_that_of_a_sphere_and_not_of_its_voxels) {
  for (const Real r : {6.0, 10.0, 15.0}) {
    const int n = 2 * static_cast<int>(r) + 12;
    const Voxels voxels = support::rasterise({n, n, n}, [&](const Vec3& x) {
      return norm(x - Vec3{0.5 * n + 0.2, 0.5 * n, 0.5 * n}) - r;
    });
    const VoxelSolid solid = whole_solid(voxels.view(), 1e-6, mirrored, 1);
    EXPECT_NEAR(surface_area(solid, 0) / (4 * std::numbers::pi * r * r * 1e-12), 1, 0.03) << r;
  }
}

TEST(Metrics, local_thickness_of_a_slit_and_a_tube_is_their_width) {
  const Voxels slit =
      support::rasterise({50, 40, 1}, [](const Vec3& x) { return 6 - std::abs(x.y - 20); });
  for (const float t : local_thickness(whole_solid(slit.view(), 1, mirrored, 1))) {
    if (t > 0) {
      EXPECT_NEAR(t, 12, 0.3);
    }
  }
  const Voxels tube = support::rasterise(
      {30, 30, 24}, [](const Vec3& x) { return 9 - std::hypot(x.x - 15, x.y - 15); });
  const auto thickness = local_thickness(whole_solid(tube.view(), 1, mirrored, 1));
  EXPECT_NEAR(thickness[static_cast<std::size_t>(voxel_index(tube.n, 15, 15, 12))], 18, 0.7);
  EXPECT_NEAR(thickness[static_cast<std::size_t>(voxel_index(tube.n, 8, 15, 12))], 18, 0.7);
}

TEST(Metrics, two_balls_joined_by_a_neck_are_two_pores_with_one_throat_in_3d) {
  const Voxels voxels = support::rasterise({60, 32, 32}, [](const Vec3& x) {
    const Real tube = 4 - std::hypot(x.y - 16, x.z - 16);
    const Real neck = std::min(tube, std::min(x.x - 15, 45 - x.x));
    return std::max({12 - norm(x - Vec3{15, 16, 16}), 12 - norm(x - Vec3{45, 16, 16}), neck});
  });
  const VoxelSolid solid = whole_solid(voxels.view(), 1, mirrored, 1);
  const Basins pores = find_basins(solid, Phase::pore, {});
  EXPECT_EQ(pores.voxels.size(), 2U);
  const auto throats = find_throats(solid, pores, {});
  ASSERT_EQ(throats.size(), 1U);
  EXPECT_NEAR(throats[0].width, 8, 0.5);
  EXPECT_GT(throats[0].centre.x, 25);
  EXPECT_LT(throats[0].centre.x, 35);
}

TEST(SizeDistribution, quantiles_and_means_are_weighted) {
  SizeDistribution d{{3, 1, 2}, {1, 2, 1}};
  d.sort();
  EXPECT_DOUBLE_EQ(d.mean(), 7.0 / 4);
  EXPECT_DOUBLE_EQ(d.quantile(0.5), 1);
  EXPECT_DOUBLE_EQ(d.quantile(0.75), 2);
  EXPECT_TRUE(std::isnan(SizeDistribution{}.mean()));
}

}  // namespace porefines::geom
