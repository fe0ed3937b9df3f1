// SPDX-License-Identifier: MPL-2.0
#include <algorithm>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "geom/image_read.hpp"
#include "geom/image_write.hpp"
#include "geom/metrics.hpp"
#include "geom/pore_size.hpp"
#include "report/draw_geometry.hpp"
#include "report/draw_histogram.hpp"
#include "unit/geom_support.hpp"

namespace porefines::geom {

namespace {

constexpr Surroundings mirrored{Beyond::mirror, Beyond::mirror, Beyond::mirror};

Voxels two_grains() {
  return support::rasterise({120, 60, 1}, [](const Vec3& x) {
    return std::min(std::hypot(x.x - 60, x.y - 10) - 22, std::hypot(x.x - 60, x.y - 58) - 18);
  });
}

/// Pixels of the picture that have exactly this colour.
Index count_colour(const report::Picture& picture, const report::Rgb& colour) {
  Index count = 0;
  for (std::size_t p = 0; p < picture.rgb.size(); p += 3) {
    count += picture.rgb[p] == colour[0] && picture.rgb[p + 1] == colour[1] &&
                     picture.rgb[p + 2] == colour[2]
                 ? 1
                 : 0;
  }
  return count;
}

}  // namespace

TEST(ImageWrite, what_is_written_reads_back) {
  const auto folder = support::scratch("write");
  Voxels volume = make_voxels({7, 5, 3}, 0);
  for (std::size_t v = 0; v < volume.pore.size(); v += 3) {
    volume.pore[v] = 1;
  }
  write_image((folder / "a.tif").string(), volume.view());
  const auto back = read_image((folder / "a.tif").string());
  ASSERT_EQ(back.n, volume.n);
  for (std::size_t v = 0; v < volume.pore.size(); ++v) {
    ASSERT_EQ(back.grey[v], 255 * volume.pore[v]);
  }
  EXPECT_THROW(write_image((folder / "a.png").string(), volume.view()), InputError);
  const Voxels flat = two_grains();
  write_image((folder / "b.png").string(), flat.view());
  EXPECT_EQ(read_image((folder / "b.png").string()).grey[60 + 120 * 10], 0);
}

TEST(DrawGeometry, shows_grains_and_what_cleaning_changed_in_their_shares) {
  const Voxels kept = two_grains();
  Voxels found = kept;
  for (int j = 5; j < 15; ++j) {
    for (int i = 55; i < 65; ++i) {
      found.at(i, j, 0) = 1;  // a dead pore of 100 pixels inside the lower grain
    }
  }
  const VoxelSolid solid = whole_solid(kept.view(), 2e-6, mirrored, 1);
  const Metrics m = measure(kept.view(), 2e-6, mirrored, {});
  const auto picture = report::draw_geometry(
      {found.view(), kept.view(), &solid, &m.throats, BoxFace::x_high}, "two grains", 600);
  const Real area = 5 * 5;  // picture pixels per voxel
  EXPECT_NEAR(static_cast<Real>(count_colour(picture, {226, 120, 92})), 100 * area, 30 * area);
  EXPECT_GT(static_cast<Real>(count_colour(picture, {190, 172, 146})), 1400 * area);
  EXPECT_LT(static_cast<Real>(count_colour(picture, {190, 172, 146})), 2000 * area);
  EXPECT_EQ(count_colour(picture, {150, 205, 150}), 0);  // nothing was opened
}

TEST(DrawHistogram, the_highest_bar_is_where_most_of_the_weight_is) {
  const SizeDistribution sizes{{1e-6, 2e-6, 9e-6, 10e-6}, {1, 1, 1, 20}};
  const auto picture = report::draw_histogram(sizes, {.title = "t", .quantity = "q", .share = "s"});
  std::vector<Index> column(static_cast<std::size_t>(picture.width), 0);
  for (std::size_t p = 0; p < picture.rgb.size(); p += 3) {
    const bool bar = picture.rgb[p] == 96 && picture.rgb[p + 1] == 140 && picture.rgb[p + 2] == 178;
    column[p / 3 % column.size()] += bar ? 1 : 0;
  }
  const auto highest = std::max_element(column.begin(), column.end()) - column.begin();
  EXPECT_GT(highest, 780);  // right end of the plot
  EXPECT_GT(column[static_cast<std::size_t>(highest)], 300);
  EXPECT_EQ(column[450], 0);
  EXPECT_GT(report::draw_histogram({}, {.title = "empty"}).width, 0);
}

}  // namespace porefines::geom
