// SPDX-License-Identifier: MPL-2.0
// Grey pictures: voxels at the surface say how much of them is pore.
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "geom/segment.hpp"
#include "geom/voxel_solid.hpp"
#include "unit/geom_support.hpp"

namespace porefines::geom {
namespace {

constexpr Surroundings open{Beyond::pore, Beyond::pore, Beyond::pore};

/// A dark disc or plane on bright ground as a camera sees it: 10 x 10 points a pixel.
GreyVolume photograph(const Int3& n, const std::function<Real(const Vec3&)>& distance, Real noise) {
  constexpr int points = 10;
  constexpr Real dark = 40;
  constexpr Real bright = 200;
  std::mt19937 random(3);
  std::normal_distribution<Real> normal(0, 1);
  GreyVolume image{n, {}};
  for (int j = 0; j < n[1]; ++j) {
    for (int i = 0; i < n[0]; ++i) {
      int pore = 0;
      for (int p = 0; p < points * points; ++p) {
        pore += distance({i + (p % points + 0.5) / points, j + (p / points + 0.5) / points, 0}) > 0;
      }
      const Real level = dark + (bright - dark) * pore / (points * points) + noise * normal(random);
      image.grey.push_back(static_cast<std::uint8_t>(std::clamp(std::lround(level), 0L, 255L)));
    }
  }
  return image;
}

Voxels by_otsu(const GreyVolume& image) {
  Segmentation how;
  how.otsu = true;
  return segment(image, how, "photograph");
}

struct Off {
  Real rms = 0;
  Real most = 0;
};

/// Of the distance within a pixel of the surface, over discs of one radius at several places.
Off off_surface(Real radius, Real noise, bool with_shares) {
  constexpr int size = 64;
  std::mt19937 random(1);
  std::uniform_real_distribution<Real> uniform(0, 1);
  Off off;
  Index count = 0;
  for (int place = 0; place < 6; ++place) {
    const Vec3 centre{32 + uniform(random), 32 + uniform(random), 0};
    const auto exact = [&](const Vec3& x) {
      return std::hypot(x.x - centre.x, x.y - centre.y) - radius;
    };
    Voxels voxels = by_otsu(photograph({size, size, 1}, exact, noise));
    if (!with_shares) {
      voxels.share.clear();
    }
    const auto solid = smooth_solid(voxels.view(), 1, open, {{0, 0, 0}, voxels.n}, {1, 8});
    for (int v = 0; v < size * size; ++v) {
      const Vec3 x{v % size + 0.5, v / size + 0.5, 0};
      if (std::abs(exact(x)) < 1) {
        const Real error = solid.s[static_cast<std::size_t>(v)] - exact(x);
        off.rms += error * error;
        off.most = std::max(off.most, std::abs(error));
        ++count;
      }
    }
  }
  off.rms = std::sqrt(off.rms / static_cast<Real>(count));
  return off;
}

}  // namespace

TEST(GreyPicture, disc_is_found_to_a_few_hundredths_of_a_pixel) {
  for (const Real radius : {5.0, 8.0, 12.0, 20.0}) {
    const Off grey = off_surface(radius, 0, true);
    const Off binary = off_surface(radius, 0, false);
    std::printf("[ measured ] radius %.0f: rms %.4f, most %.4f pixels; binary %.4f, %.4f\n", radius,
                grey.rms, grey.most, binary.rms, binary.most);
    EXPECT_LT(grey.rms, 0.03) << radius;
    EXPECT_LT(grey.most, 0.1) << radius;
  }
}

/// Noise of a tenth of the contrast: still far better than without the shares.
TEST(GreyPicture, noise_of_a_tenth_does_little) {
  for (const Real radius : {8.0, 20.0}) {
    const Off grey = off_surface(radius, 16, true);
    const Off binary = off_surface(radius, 16, false);
    std::printf("[ measured ] radius %.0f: rms %.4f; binary %.4f\n", radius, grey.rms, binary.rms);
    EXPECT_LT(grey.rms, 0.5 * binary.rms) << radius;
  }
}

TEST(GreyPicture, shares_only_beside_the_surface_and_none_in_a_binary_picture) {
  const auto wall = [](const Vec3& x) { return x.x - 10.3; };
  const Voxels voxels = by_otsu(photograph({20, 8, 1}, wall, 0));
  ASSERT_FALSE(voxels.share.empty());
  for (int i = 0; i < 20; ++i) {
    const int share = voxels.share[static_cast<std::size_t>(i)];
    EXPECT_NEAR(share, i < 10 ? 0 : i == 10 ? 0.7 * full_share : full_share, 2) << i;
    EXPECT_EQ(2 * share >= full_share, voxels.at(i, 0, 0)) << i;
  }
  EXPECT_TRUE(by_otsu(photograph(
                          {20, 8, 1}, [](const Vec3& x) { return x.x - 10; }, 0))
                  .share.empty());
}

TEST(GreyPicture, edits_overrule_shares) {
  Voxels voxels = by_otsu(photograph(
      {20, 8, 1}, [](const Vec3& x) { return x.x - 10.3; }, 0));
  voxels.at(10, 3, 0) = 0;
  voxels.at(2, 3, 0) = 1;
  keep_shares_of_unchanged(voxels);
  EXPECT_EQ(voxels.share[static_cast<std::size_t>(voxel_index(voxels.n, 10, 3, 0))], 0);
  EXPECT_EQ(voxels.share[static_cast<std::size_t>(voxel_index(voxels.n, 2, 3, 0))], full_share);
  EXPECT_NEAR(voxels.share[static_cast<std::size_t>(voxel_index(voxels.n, 10, 4, 0))],
              0.7 * full_share, 2);
}

}  // namespace porefines::geom
