// SPDX-License-Identifier: MPL-2.0
// Pictures: colour maps, ticks, orientation, grains, ranges.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "report/picture.hpp"
#include "report/picture_colormap.hpp"
#include "report/picture_ticks.hpp"

namespace porefines {
namespace {

using report::Colormap;
using report::Rgb;

TEST(picture_colormap, equal_steps_look_equally_different) {
  for (const Colormap map :
       {Colormap::speed, Colormap::pressure, Colormap::diverging, Colormap::pale, Colormap::rock}) {
    std::vector<Real> steps;
    for (int i = 0; i + 1 <= 16; ++i) {
      steps.push_back(
          report::difference(report::colour(map, i / 16.0), report::colour(map, (i + 1) / 16.0)));
    }
    const auto [least, most] = std::minmax_element(steps.begin(), steps.end());
    EXPECT_LT(*most / *least, 1.25) << "map " << static_cast<int>(map);
  }
}

TEST(picture_colormap, lightness_is_monotone) {
  for (int i = 0; i < 64; ++i) {
    const Real a = i / 64.0;
    const Real b = (i + 1) / 64.0;
    EXPECT_LT(report::lightness(report::colour(Colormap::speed, a)),
              report::lightness(report::colour(Colormap::speed, b)));
    for (const Colormap map : {Colormap::pressure, Colormap::pale, Colormap::rock}) {
      EXPECT_GT(report::lightness(report::colour(map, a)),
                report::lightness(report::colour(map, b)));
    }
    EXPECT_GT(report::lightness(report::colour(Colormap::diverging, 0.5 + a / 2)),
              report::lightness(report::colour(Colormap::diverging, 0.5 + b / 2)));
  }
  EXPECT_EQ(report::colour(Colormap::speed, -3), report::colour(Colormap::speed, 0));
  EXPECT_EQ(report::colour(Colormap::speed, 3), report::colour(Colormap::speed, 1));
  EXPECT_EQ(report::colour(Colormap::speed, std::nan("")), (Rgb{255, 255, 255}));
}

TEST(picture_ticks, units_get_engineering_prefixes_or_powers_of_ten) {
  EXPECT_EQ(report::display_unit(3.2e-5, "m/s").text, "µm/s");
  EXPECT_EQ(report::display_unit(1e-6, "m").text, "µm");
  EXPECT_EQ(report::display_unit(999e-9, "m").text, "nm");
  EXPECT_EQ(report::display_unit(12, "Pa").text, "Pa");
  EXPECT_EQ(report::display_unit(1.2e4, "Pa").text, "kPa");
  EXPECT_DOUBLE_EQ(report::display_unit(1.2e4, "Pa").factor, 1000);
  EXPECT_EQ(report::display_unit(2e-12, "m^2").text, "10^-12 m^2");
  EXPECT_EQ(report::display_unit(2e-4, "").text, "10^-6");
  EXPECT_EQ(report::display_unit(0, "Pa").text, "Pa");
}

TEST(picture_ticks, are_round_and_inside) {
  const auto ticks = report::nice_ticks(-0.07, 0.31, 5);
  ASSERT_GE(ticks.size(), 4U);
  for (const Real tick : ticks) {
    EXPECT_GE(tick, -0.07);
    EXPECT_LE(tick, 0.31);
    EXPECT_NEAR(tick / 0.05, std::round(tick / 0.05), 1e-9);
  }
  EXPECT_EQ(std::count(ticks.begin(), ticks.end(), 0.0), 1);
  EXPECT_DOUBLE_EQ(report::nice_below(73), 50);
  EXPECT_DOUBLE_EQ(report::nice_below(1e-6), 1e-6);
  EXPECT_DOUBLE_EQ(report::nice_below(4.9e-3), 2e-3);
  EXPECT_EQ(report::tick_text(0.25, 0.05), "0.25");
  EXPECT_EQ(report::tick_text(200, 100), "200");
  EXPECT_TRUE(report::nice_ticks(1, 1, 5).empty());
}

/// Pixels of exactly this colour, and their mean place as a fraction of the picture.
struct Patch {
  int pixels = 0;
  Real x = 0;
  Real y = 0;  ///< from the top
};

Patch find(const report::Picture& picture, const Rgb& wanted, int right_end) {
  Patch patch;
  for (int row = 0; row < picture.height; ++row) {
    for (int column = 0; column < right_end; ++column) {
      const auto* pixel =
          &picture.rgb[3 * (static_cast<std::size_t>(row) * picture.width + column)];
      if (std::equal(wanted.begin(), wanted.end(), pixel)) {
        ++patch.pixels;
        patch.x += column;
        patch.y += row;
      }
    }
  }
  patch.x /= std::max(1, patch.pixels) * static_cast<Real>(picture.width);
  patch.y /= std::max(1, patch.pixels) * static_cast<Real>(picture.height);
  return patch;
}

TEST(picture, row_zero_is_at_the_bottom_and_cells_fill_their_place) {
  const std::vector<float> values{1, 0, 0, 0, 0, 0};  // 3 x 2; the high value at low x, low y
  const report::Slice slice{values, 3, 2, {}, 1e-6, 2e-6};
  report::PictureStyle style;
  style.smooth = false;
  style.longer_side = 300;
  style.range = {0, 1};
  const auto picture = report::draw_slice(slice, style);
  const int plot_end = 36 + 225 + 2;
  const Patch high = find(picture, report::colour(Colormap::speed, 1), plot_end);
  // 4 um high in 300 pixels, so 75 pixels per um: a cell is 75 x 150.
  EXPECT_EQ(high.pixels, 75 * 150);
  const Patch low = find(picture, report::colour(Colormap::speed, 0), plot_end);
  EXPECT_EQ(low.pixels, 5 * 75 * 150);
  EXPECT_LT(high.x, low.x);
  EXPECT_GT(high.y, low.y);
}

TEST(picture, grains_are_not_coloured_and_do_not_smear_into_the_fluid) {
  std::vector<float> values(20 * 20, 0.5F);
  std::vector<std::uint8_t> grain(values.size(), 0);
  for (int j = 5; j < 15; ++j) {
    for (int i = 5; i < 15; ++i) {
      values[20 * j + i] = 1e9F;  // must not be seen
      grain[20 * j + i] = 1;
    }
  }
  const report::Slice slice{values, 20, 20, grain, 1e-6, 1e-6};
  report::PictureStyle style;
  style.longer_side = 400;
  style.range = {0, 1};
  const auto picture = report::draw_slice(slice, style);
  const int plot_end = 36 + 400 + 2;
  EXPECT_EQ(find(picture, report::colour(Colormap::speed, 1), plot_end).pixels, 0);
  // 300 of 400 cells are fluid, 400 pixels each; the outline takes a little.
  EXPECT_NEAR(find(picture, report::colour(Colormap::speed, 0.5), plot_end).pixels, 300 * 400,
              2500);
  const auto range = report::value_range(std::span(&slice, 1), style);
  EXPECT_LT(range[1], 1);
}

TEST(picture, ranges_are_never_empty) {
  report::PictureStyle style;
  std::vector<float> same(9, 4.0F);
  std::vector<float> none(9, std::numeric_limits<float>::quiet_NaN());
  for (const bool logarithmic : {false, true}) {
    style.logarithmic = logarithmic;
    for (const auto* values : {&same, &none}) {
      const report::Slice slice{*values, 3, 3};
      const auto [low, high] = report::value_range(std::span(&slice, 1), style);
      EXPECT_LT(low, high);
      EXPECT_TRUE(!logarithmic || low > 0);
      EXPECT_GT(report::draw_slice(slice, style).width, 1000);
    }
  }
  style.logarithmic = false;
  style.colormap = Colormap::diverging;
  const std::vector<float> both{-1, 0, 3};
  const report::Slice slice{both, 3, 1};
  EXPECT_EQ(report::value_range(std::span(&slice, 1), style), (std::array<Real, 2>{-3, 3}));
  const report::Slice broken{both, 2, 1};
  EXPECT_THROW((void)report::draw_slice(broken, style), RunError);
}

TEST(picture, large_slices_are_reduced_to_the_mean) {
  std::vector<float> values(std::size_t{2400} * 4, 0.0F);
  for (std::size_t i = 0; i < values.size(); i += 2) {
    values[i] = 1;  // stripes finer than a pixel
  }
  const report::Slice slice{values, 2400, 4, {}, 1e-6, 1e-6};
  report::PictureStyle style;
  style.longer_side = 1200;
  style.range = {0, 1};
  const auto picture = report::draw_slice(slice, style);
  EXPECT_EQ(find(picture, report::colour(Colormap::speed, 0.5), 36 + 1200 + 2).pixels, 1200 * 2);
}

TEST(picture, mid_slices_take_the_right_plane_and_axes) {
  const Int3 cells{4, 3, 2};
  std::vector<float> values;
  for (int k = 0; k < 2; ++k) {
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 4; ++i) {
        values.push_back(static_cast<float>(i + 10 * j + 100 * k));
      }
    }
  }
  const Vec3 spacing{1, 2, 4};
  const auto z = report::mid_slice(values, {}, cells, spacing, 2);
  EXPECT_EQ(z.values.at(5), 100 + 10 + 1);
  const auto y = report::mid_slice(values, {}, cells, spacing, 1);
  EXPECT_EQ(y.values, (std::vector<float>{10, 11, 12, 13, 110, 111, 112, 113}));
  EXPECT_EQ(y.shape.cell_height, 4);
  const auto x = report::mid_slice(values, {}, cells, spacing, 0);
  EXPECT_EQ(x.values, (std::vector<float>{2, 102, 12, 112, 22, 122}));
  EXPECT_EQ(x.shape.width, 2);
  EXPECT_EQ(x.shape.cell_width, 4);
  EXPECT_EQ(x.shape.position, 2.5);
  const auto picture = report::draw_three_slices({x.view(), y.view(), z.view()}, {});
  EXPECT_GT(picture.width, 800);
  EXPECT_EQ(picture.rgb.size(), std::size_t{3} * picture.width * picture.height);
}

}  // namespace
}  // namespace porefines
