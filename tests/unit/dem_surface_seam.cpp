// SPDX-License-Identifier: MPL-2.0
#include <gtest/gtest.h>

#include "dem/surface.hpp"
#include "geom/build.hpp"
#include "unit/geom_support.hpp"

namespace porefines::dem {

namespace {

geom::Sample pictured_ball() {
  geom::Sample sample;
  sample.spec.kind = geom::Kind::image;
  sample.pixel = 1e-6;
  auto voxels =
      std::make_shared<geom::Voxels>(geom::support::rasterise({40, 40, 40}, [](const Vec3& x) {
        return norm(x - Vec3{20.3, 20.1, 19.8}) - 10;
      }));
  sample.voxels = {voxels->n, {voxels, voxels->pore.data()}};
  sample.box = {{40e-6, 40e-6, 40e-6},
                {geom::Beyond::periodic, geom::Beyond::mirror, geom::Beyond::pore}};
  return sample;
}

/// What a rank needs that owns the box {low, high} of the sample.
Surfaces grains_of_block(const geom::Sample& sample, const Vec3& low, const Vec3& high,
                         Real largest, const Vec3& corner) {
  const Real margin = largest + 6 * sample.pixel;
  const Vec3 beyond{margin, margin, margin};
  const geom::Solid solid = geom::make_solid(sample, low - beyond, high + beyond, 6e-6);
  return {Fixed(make_field(std::get<geom::VoxelSolid>(solid), largest, corner))};
}

}  // namespace

TEST(DistanceField, blocks_of_two_ranks_agree_bitwise_at_their_seam_and_cover_their_particles) {
  const geom::Sample sample = pictured_ball();
  const Vec3 corner{0, 0, 5e-6};
  const Real d = 8e-6;
  const auto left = grains_of_block(sample, {0, 0, 0}, {20e-6, 40e-6, 40e-6}, 0.6 * d, corner);
  const auto right = grains_of_block(sample, {20e-6, 0, 0}, {40e-6, 40e-6, 40e-6}, 0.6 * d, corner);
  int met = 0;
  for (int j = 0; j < 40; ++j) {
    for (int k = 0; k < 40; ++k) {
      const Vec3 seam = corner + 1e-6 * Vec3{20, j + 0.5, k + 0.5};
      TouchList a;
      TouchList b;
      find_touches(left, seam, d / 2, 0.1 * d, a);
      find_touches(right, seam, d / 2, 0.1 * d, b);
      EXPECT_FALSE(a.uncovered || b.uncovered);
      ASSERT_EQ(a.count, b.count);
      for (std::size_t t = 0; t < static_cast<std::size_t>(a.count); ++t) {
        ASSERT_EQ(a.touch[t].gap, b.touch[t].gap);
        ASSERT_EQ(a.touch[t].normal, b.touch[t].normal);
        ++met;
      }
      TouchList border;
      find_touches(left, corner + 1e-6 * Vec3{0, j + 0.5, k + 0.5}, d / 2, 0.1 * d, border);
      EXPECT_FALSE(border.uncovered);
    }
  }
  EXPECT_GT(met, 100);
}

}  // namespace porefines::dem
