// SPDX-License-Identifier: MPL-2.0
// Pictures of a run: everybody is where he is, in the colour of what he does.
#include "report/draw_run.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "report/picture_parts.hpp"

namespace porefines::report {
namespace {

using analysis::Fate;

constexpr Int3 cells{120, 80, 40};
constexpr Vec3 spacing{2e-6, 2e-6, 2e-6};

SliceValues plane(int axis, float value) {
  const std::vector<float> values(static_cast<std::size_t>(product(cells)), value);
  const std::vector<std::uint8_t> grain(values.size(), 0);
  return mid_slice(values, grain, cells, spacing, axis);
}

std::array<SliceValues, 3> planes(float value) {
  return {plane(0, value), plane(1, value), plane(2, value)};
}

std::array<Slice, 3> views(const std::array<SliceValues, 3>& slices) {
  return {slices[0].view(), slices[1].view(), slices[2].view()};
}

Real area_of(const Picture& picture, const Rgb& colour) {
  Real count = 0;
  for (std::size_t p = 0; p < picture.rgb.size(); p += 3) {
    count += picture.rgb[p] == colour[0] && picture.rgb[p + 1] == colour[1] &&
             picture.rgb[p + 2] == colour[2];
  }
  return count;
}

Rgb at(const Picture& picture, int x, int y) {
  const auto p = 3 * (static_cast<std::size_t>(y) * picture.width + x);
  return {picture.rgb[p], picture.rgb[p + 1], picture.rgb[p + 2]};
}

/// One pixel a micrometre: 240 x 160 of the plot, which begins at (margin, title + rest of the bar).
RunStyle small_style() {
  RunStyle style;
  style.title = "t";
  style.longer_side = 240;
  return style;
}

}  // namespace

TEST(DrawRun, fines_of_a_chip_lie_where_they_are_in_the_colour_of_their_fate) {
  RunView view;
  view.low = {-20e-6, 0, 0};
  view.fines = {{{30e-6, 40e-6, 5e-6}, 12e-6, 0, Fate::bridging},
                {{150e-6, 100e-6, 5e-6}, 12e-6, 0, Fate::clogged},
                {{152e-6, 100e-6, 1e-6}, 12e-6, 0, Fate::piping}};  // below the one before
  const Picture picture = draw_chip(plane(2, 1e-3F).view(), view, small_style());
  const int left = layout::margin;
  const int bottom = layout::title + (layout::shortest_bar - 160) / 2 + 160;
  EXPECT_EQ(at(picture, left + 50, bottom - 40), colour_of(Fate::bridging));
  EXPECT_EQ(at(picture, left + 170, bottom - 100), colour_of(Fate::clogged));
  EXPECT_EQ(at(picture, left + 170 - 16, bottom - 100), at(picture, left + 100, bottom - 20));
  const Real dot = area_of(draw_chip(plane(2, 1e-3F).view(), {}, small_style()),
                           colour_of(Fate::bridging));  // in the legend
  EXPECT_NEAR(area_of(picture, colour_of(Fate::bridging)) - dot, std::numbers::pi * 100, 45);
}

TEST(DrawRun, by_speed_they_have_the_colour_of_a_flow_of_that_speed) {
  RunView view;
  view.fines = {{{60e-6, 80e-6, 0}, 20e-6, 1e-3, Fate::piping}};
  RunStyle style = small_style();
  style.colour = FineColour::speed;
  style.range = {0, 2e-3};
  const Picture slow = draw_chip(plane(2, 2e-3F).view(), view, style);
  const Picture flow = draw_chip(plane(2, 1e-3F).view(), {}, style);
  const int x = layout::margin + 60;
  const int y = layout::title + layout::shortest_bar / 2;
  EXPECT_EQ(at(slow, x, y), at(flow, x, y));
  EXPECT_NE(at(slow, x, y), at(slow, x + 60, y));
}

TEST(DrawRun, a_plane_shows_those_that_it_cuts_and_a_projection_shows_all) {
  RunView view;
  view.fines = {{{100e-6, 80e-6, 41e-6}, 16e-6, 0, Fate::bridging},  // on all middle planes? z
                {{100e-6, 80e-6, 41e-6 + 9.6e-6}, 16e-6, 0, Fate::clogged}};  // cut at 0.6 r: 0.8 r
  RunStyle style = small_style();
  style.longer_side = 600;
  const auto flow = planes(1e-3F);
  const auto alone = [&](std::size_t n) {
    RunView one;
    one.fines = {view.fines[n]};
    const Picture empty = draw_planes(views(flow), {}, style);
    return area_of(draw_planes(views(flow), one, style), colour_of(view.fines[n].fate)) -
           area_of(empty, colour_of(view.fines[n].fate));
  };
  // planes at z = 41, y = 81, x = 121 um: the first is cut by two of them in full, by x not at all
  EXPECT_NEAR(alone(1) / alone(0), (0.64 + 1) / 2, 0.06);
  const auto rock = planes(0.3F);
  const Picture all = draw_projections(views(rock), view, style);
  const Picture none = draw_projections(views(rock), {}, style);
  for (const Fate fate : {Fate::bridging, Fate::clogged}) {
    EXPECT_GT(area_of(all, colour_of(fate)), area_of(none, colour_of(fate)) + 200);
  }
}

TEST(DrawRun, along_x_the_nearer_of_two_hides_the_other) {
  RunView view;
  view.fines = {{{20e-6, 80e-6, 40e-6}, 14e-6, 0, Fate::bridging},
                {{200e-6, 80e-6, 40e-6}, 14e-6, 0, Fate::clogged}};
  RunStyle style = small_style();
  style.longer_side = 600;
  const auto rock = planes(0.3F);
  const Picture both = draw_projections(views(rock), view, style);
  std::swap(view.fines[0].fate, view.fines[1].fate);
  const Picture swapped = draw_projections(views(rock), view, style);
  // one looks from x-, y-, z+: along x the first hides the second, elsewhere both are seen
  EXPECT_GT(area_of(both, colour_of(Fate::bridging)),
            1.3 * area_of(both, colour_of(Fate::clogged)));
  EXPECT_EQ(area_of(both, colour_of(Fate::bridging)), area_of(swapped, colour_of(Fate::clogged)));
}

TEST(DrawRun, mean_along_an_axis_is_the_mean) {
  std::vector<float> values;
  for (int k = 0; k < 4; ++k) {
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 2; ++i) {
        values.push_back(static_cast<float>(i + 10 * j + 100 * k));
      }
    }
  }
  EXPECT_EQ(mean_along(values, {2, 3, 4}, spacing, 2).values,
            (std::vector<float>{150, 151, 160, 161, 170, 171}));
  EXPECT_EQ(mean_along(values, {2, 3, 4}, spacing, 1).values,
            (std::vector<float>{10, 11, 110, 111, 210, 211, 310, 311}));
  const auto along_x = mean_along(values, {2, 3, 4}, spacing, 0);  // z to the right, y up
  EXPECT_EQ(along_x.shape.width, 4);
  EXPECT_EQ(along_x.values[1], 100.5F);
  EXPECT_EQ(along_x.values[4], 10.5F);
  EXPECT_THROW((void)mean_along(values, {2, 3, 5}, spacing, 0), RunError);
}

}  // namespace porefines::report
