// SPDX-License-Identifier: MPL-2.0
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "geom/edit.hpp"
#include "unit/geom_support.hpp"

namespace porefines::geom {

namespace {

constexpr Surroundings mirrored{Beyond::mirror, Beyond::mirror, Beyond::mirror};

Index grains_in(const Voxels& voxels) {
  return product(voxels.n) - std::count(voxels.pore.begin(), voxels.pore.end(), 1);
}

Voxels disc(Real radius) {
  return support::rasterise(
      {64, 64, 1}, [&](const Vec3& x) { return std::hypot(x[0] - 32, x[1] - 32) - radius; });
}

}  // namespace

TEST(Erosion, takes_layers_off_a_wall) {
  const Voxels wall = support::from_picture({"...####...", "...####...", "...####..."});
  for (const auto& [depth, left] :
       {std::pair{0.49, 12}, {0.51, 6}, {1.0, 6}, {1.49, 6}, {1.51, 0}}) {
    Voxels voxels = wall;
    EXPECT_EQ(erode_grains(voxels, depth, mirrored), 12 - left);
    EXPECT_EQ(grains_in(voxels), left) << depth;
  }
}

TEST(Erosion, of_a_disc_leaves_a_smaller_disc) {
  for (const Real depth : {1.0, 3.0, 7.0}) {
    Voxels voxels = disc(20);
    erode_grains(voxels, depth, mirrored);
    const Real radius = std::sqrt(static_cast<Real>(grains_in(voxels)) / std::numbers::pi);
    EXPECT_NEAR(radius, 20 - depth, 0.35) << "half a pixel at most, less in the mean";
  }
}

TEST(Erosion, works_around_a_period_and_not_from_a_reservoir) {
  const Voxels wall = support::from_picture({"####......", "####......"});
  Voxels voxels = wall;
  EXPECT_EQ(erode_grains(voxels, 1, {Beyond::periodic, Beyond::mirror, Beyond::mirror}), 4);
  EXPECT_TRUE(voxels.at(0, 0, 0));
  voxels = wall;
  EXPECT_EQ(erode_grains(voxels, 1, {Beyond::pore, Beyond::mirror, Beyond::mirror}), 2);
  EXPECT_FALSE(voxels.at(0, 0, 0));
}

TEST(EditMask, opens_white_closes_black_and_leaves_grey) {
  Voxels voxels = support::from_picture({"##..", "##.."});
  const GreyVolume mask{{4, 2, 1}, {128, 255, 255, 0, 1, 254, 77, 0}};
  EXPECT_EQ(apply_edit_mask(voxels, mask, "mask.png"), 3);
  const std::vector<std::uint8_t> wanted{0, 1, 1, 0, 0, 0, 1, 0};
  EXPECT_EQ(voxels.pore, wanted);
}

TEST(EditMask, that_cannot_be_meant_is_refused) {
  Voxels voxels = support::from_picture({"##..", "##.."});
  const auto refused = [&](const GreyVolume& mask) {
    try {
      apply_edit_mask(voxels, mask, "mask.png");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refused({{4, 1, 1}, {0, 128, 128, 128}}).find("4 x 1 x 1 voxels, the image 4 x 2 x 1"),
            std::string::npos);
  EXPECT_NE(refused({{4, 2, 1}, std::vector<std::uint8_t>(8, 128)}).find("no voxel"),
            std::string::npos);
  EXPECT_NE(refused({{4, 2, 1}, {0, 0, 0, 0, 255, 255, 255, 255}}).find("every voxel"),
            std::string::npos);
}

}  // namespace porefines::geom
