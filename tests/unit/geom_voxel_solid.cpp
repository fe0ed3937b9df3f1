// SPDX-License-Identifier: MPL-2.0
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "geom/voxel_solid.hpp"
#include "unit/geom_support.hpp"

namespace porefines::geom {

namespace {

constexpr Surroundings open{Beyond::pore, Beyond::pore, Beyond::pore};
constexpr Surroundings mirrored{Beyond::mirror, Beyond::mirror, Beyond::mirror};

struct Errors {
  Real near = 0;    ///< rms |s - exact| within 1.5 pixels of the surface
  Real mean = 0;    ///< and its mean
  Real far = 0;     ///< rms from there to 7 pixels
  Real slope = 0;   ///< rms of |grad s| - 1
  Real volume = 0;  ///< grain volume / volume of the rasterised grain - 1
};

/// A disc or sphere of radius r at random sub-pixel positions.
Errors measure_ball(int dims, Real r, int positions) {
  std::mt19937 random(1);
  std::uniform_real_distribution<Real> uniform(0, 1);
  Errors e;
  Index near = 0;
  Index far = 0;
  Index slopes = 0;
  Real grain = 0;
  Real raster = 0;
  const int size = 2 * static_cast<int>(r) + 22;
  for (int position = 0; position < positions; ++position) {
    const Vec3 centre{0.5 * size + uniform(random), 0.5 * size + uniform(random),
                      dims == 2 ? 0.5 : 0.5 * size + uniform(random)};
    const auto exact = [&](const Vec3& x) { return norm(x - centre) - r; };
    const Voxels voxels = support::rasterise({size, size, dims == 2 ? 1 : size}, exact);
    const auto solid = smooth_solid(voxels.view(), 1, open, {{0, 0, 0}, voxels.n}, {1, 8});
    for (std::size_t v = 0; v < solid.s.size(); ++v) {
      const auto at = static_cast<int>(v);
      const Vec3 x{at % size + 0.5, at / size % size + 0.5, at / size / size + 0.5};
      const Real d = exact(x);
      const Real off = solid.s[v] - d;
      if (std::abs(d) < 1.5) {
        e.near += off * off;
        e.mean += off;
        ++near;
      } else if (d < 7 && d > std::max<Real>(-7, 2 - r)) {
        e.far += off * off;
        ++far;
      }
      if (std::abs(d) < 5 && d > 2 - r) {
        Vec3 gradient;
        for (int axis = 0; axis < dims; ++axis) {
          Vec3 step;
          step[axis] = 0.5;
          gradient[axis] = signed_distance(solid, x + step) - signed_distance(solid, x - step);
        }
        e.slope += (norm(gradient) - 1) * (norm(gradient) - 1);
        ++slopes;
      }
      grain += std::clamp<Real>(0.5 - solid.s[v], 0, 1);
      raster += 1 - voxels.pore[v];
    }
  }
  return {std::sqrt(e.near / static_cast<Real>(near)), e.mean / static_cast<Real>(near),
          std::sqrt(e.far / static_cast<Real>(far)), std::sqrt(e.slope / static_cast<Real>(slopes)),
          grain / raster - 1};
}

}  // namespace

// A pixel grid knows a surface to about 0.2 pixel rms (a plane at slope 1/2 may shift by 0.45
// pixel without changing a single pixel), so a disc cannot do much better; a sphere averages more.
TEST(VoxelSolid, disc_is_found_to_a_fraction_of_a_pixel_and_keeps_its_area) {
  for (const Real r : {5.0, 8.0, 12.0, 20.0}) {
    const Errors e = measure_ball(2, r, 12);
    EXPECT_LT(e.near, 0.20) << r;
    EXPECT_NEAR(e.mean, 0, 0.02) << r;
    EXPECT_LT(e.far, 0.24) << r;
    EXPECT_LT(e.slope, 0.06) << r;
    EXPECT_NEAR(e.volume, 0, 0.006) << r;
  }
}

TEST(VoxelSolid, sphere_is_found_to_a_tenth_of_a_pixel_and_keeps_its_volume) {
  for (const Real r : {5.0, 8.0, 12.0}) {
    const Errors e = measure_ball(3, r, 3);
    EXPECT_LT(e.near, 0.13) << r;
    EXPECT_NEAR(e.mean, 0, 0.04) << r;
    EXPECT_LT(e.far, 0.20) << r;
    EXPECT_LT(e.slope, 0.055) << r;
    EXPECT_NEAR(e.volume, 0, 0.008) << r;
  }
}

TEST(VoxelSolid, wall_along_the_grid_is_exact_with_unit_slope) {
  const Voxels voxels = support::rasterise({40, 12, 1}, [](const Vec3& x) { return x.x - 20; });
  const auto solid = smooth_solid(voxels.view(), 2e-6, mirrored, {{0, 0, 0}, voxels.n}, {1, 8});
  for (int i = 12; i < 28; ++i) {
    const Vec3 centre{(i + 0.5) * 2e-6, 9e-6, 0};
    EXPECT_NEAR(signed_distance(solid, centre) / 2e-6, i + 0.5 - 20, 0.02);
  }
  EXPECT_NEAR(signed_distance(solid, {70e-6, 9e-6, 0}), 16e-6, 1e-12);  // saturates at the band
  EXPECT_NEAR(signed_distance(solid, {2e-6, 9e-6, 0}), -16e-6, 1e-12);
}

/// Planes end at an edge: beyond it the distance is that to the edge, rounded by the smoothing.
TEST(VoxelSolid, goes_round_the_end_of_a_plate_and_the_corner_of_a_square) {
  for (const Real thickness : {2.0, 3.0, 20.0}) {
    const auto exact = [&](const Vec3& x) {
      const Real out = std::max(0.0, x.x - 20);
      return x.y > 24 ? std::hypot(out, x.y - 24)
                      : std::hypot(out, std::max(0.0, 24 - thickness - x.y));
    };
    const Voxels voxels =
        support::rasterise({48, 48, 1}, [&](const Vec3& x) { return exact(x) > 0 ? 1 : -1; });
    const auto solid = smooth_solid(voxels.view(), 1, open, {{0, 0, 0}, voxels.n}, {1, 16});
    Real worst = 0;
    for (int j = 14; j < 40; ++j) {
      for (int i = 21; i < 36; ++i) {
        const Vec3 x{i + 0.5, j + 0.5, 0};
        if (exact(x) > 2 && exact(x) < 14) {
          worst = std::max(worst, std::abs(signed_distance(solid, x) - exact(x)));
        }
      }
    }
    EXPECT_LT(worst, 0.6) << thickness << " pixels thick";
  }
}

TEST(VoxelSolid, slits_keep_their_width_down_to_one_pixel) {
  for (int width = 1; width <= 6; ++width) {
    const Voxels voxels = support::rasterise(
        {40, 20, 1}, [&](const Vec3& x) { return std::min(x.x - 15, 15 + width - x.x); });
    const auto solid = smooth_solid(voxels.view(), 1, mirrored, {{0, 0, 0}, voxels.n}, {1, 8});
    Real open_width = 0;
    for (Real x = 10; x < 30; x += 0.01) {
      open_width += signed_distance(solid, {x, 10.3, 0}) > 0 ? 0.01 : 0;
    }
    EXPECT_NEAR(open_width, width, width == 1 ? 0.25 : 0.1);
    EXPECT_EQ(solid.report.rescued, width == 1 ? 20 : 0);
    EXPECT_EQ(solid.report.flipped_pores, 0);
  }
}

TEST(VoxelSolid, grains_of_two_pixels_do_not_vanish) {
  const Voxels voxels = support::from_picture(
      {"................", "................", "....##..........", "....##..........",
       "................", "...........#....", "................", "................"});
  const auto solid = smooth_solid(voxels.view(), 1, open, {{0, 0, 0}, voxels.n}, {1, 4});
  EXPECT_LT(signed_distance(solid, {5, 5, 0}), -0.3);
  EXPECT_LT(signed_distance(solid, {11.5, 2.5, 0}), -0.1);
  EXPECT_EQ(solid.report.flipped_grains, 0);
  EXPECT_GT(solid.report.rescued, 0);
}

TEST(VoxelSolid, value_at_a_voxel_does_not_depend_on_the_window) {
  std::mt19937 random(3);
  Voxels voxels = make_voxels({36, 30, 28}, 1);
  for (int ball = 0; ball < 14; ++ball) {
    const Vec3 c{random() % 3600 / 100.0, random() % 3000 / 100.0, random() % 2800 / 100.0};
    const Voxels one = support::rasterise(voxels.n, [&](const Vec3& x) { return norm(x - c) - 6; });
    for (std::size_t v = 0; v < voxels.pore.size(); ++v) {
      voxels.pore[v] &= one.pore[v];
    }
  }
  const Surroundings beyond{Beyond::periodic, Beyond::mirror, Beyond::pore};
  const auto whole = smooth_solid(voxels.view(), 1, beyond, {{-3, -3, -3}, {39, 33, 31}}, {1.2, 6});
  Index compared = 0;
  for (const Window& window : {Window{{-3, -2, -1}, {17, 14, 15}}, Window{{11, 9, 7}, {39, 33, 12}},
                               Window{{5, 5, 5}, {6, 7, 8}}}) {
    const auto part = smooth_solid(voxels.view(), 1, beyond, window, {1.2, 6});
    const Int3 n = window.size();
    for (int k = 0; k < n[2]; ++k) {
      for (int j = 0; j < n[1]; ++j) {
        for (int i = 0; i < n[0]; ++i, ++compared) {
          const auto here = static_cast<std::size_t>(voxel_index(n, i, j, k));
          const auto there = static_cast<std::size_t>(
              voxel_index({42, 36, 34}, i + window.first[0] + 3, j + window.first[1] + 3,
                          k + window.first[2] + 3));
          ASSERT_EQ(part.s[here], whole.s[there]);
        }
      }
    }
  }
  EXPECT_GT(compared, 5000);
}

TEST(VoxelSolid, sees_grains_across_periodic_faces_and_mirrors) {
  const auto grain = [](const Vec3& x) { return norm(x - Vec3{3, 20, 0.5}) - 6; };
  const Voxels voxels = support::rasterise({40, 40, 1}, grain);
  const auto wrapped =
      smooth_solid(voxels.view(), 1, {Beyond::periodic, Beyond::pore, Beyond::periodic},
                   {{-1, 0, 0}, {41, 40, 1}}, {1, 8});
  EXPECT_NEAR(signed_distance(wrapped, {37.3, 20.2, 0}), 2.7, 0.3);  // face at x = 40 cuts it
  EXPECT_NEAR(signed_distance(wrapped, {-0.4, 20.2, 0}), 0.4, 0.1);  // on the other side of it
  const auto reflected = smooth_solid(voxels.view(), 1, mirrored, {{0, 0, 0}, voxels.n}, {1, 8});
  EXPECT_NEAR(signed_distance(reflected, {37.3, 20.2, 0}), 8, 1e-9);
  EXPECT_EQ(signed_distance(reflected, {-1.25, 20.2, 0}),
            signed_distance(reflected, {1.25, 20.2, 0}));
}

TEST(VoxelSolid, refuses_a_smoothing_out_of_range) {
  const Voxels voxels = make_voxels({8, 8, 1}, 1);
  EXPECT_THROW((void)smooth_solid(voxels.view(), 1, open, {{0, 0, 0}, voxels.n}, {0.1, 8}),
               InputError);
}

}  // namespace porefines::geom
