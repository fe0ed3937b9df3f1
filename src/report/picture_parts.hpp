// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <opencv2/core.hpp>

#include "report/picture.hpp"
#include "report/picture_raster.hpp"

namespace porefines::report {

/// Sizes of what surrounds a plot, in pixels.
namespace layout {
inline constexpr int margin = 36;
inline constexpr int title = 62;    ///< above the plot
inline constexpr int footer = 66;   ///< below: scale bar and arrow
inline constexpr int bar_gap = 30;  ///< plot to colour bar
inline constexpr int bar_width = 26;
inline constexpr int bar_labels = 130;  ///< right of the colour bar
inline constexpr int shortest_bar = 320;
inline constexpr Real text = 14;  ///< height of capitals
inline constexpr Real title_text = 18;
}  // namespace layout

/// The scale for these slices under this style.
[[nodiscard]] ColourScale colour_scale(std::span<const Slice> slices, const PictureStyle& style);

/// White canvas for a plot area of this size, with the title and the colour bar in place.
/// @param plot  set to where the plot area lies
[[nodiscard]] cv::Mat start_canvas(int plot_width, int plot_height, const PictureStyle& style,
                                   const ColourScale& scale, bool values_beyond, cv::Rect& plot);

/// True when a fluid value lies above the end of the bar, which then gets a pointed end.
[[nodiscard]] bool exceeds(std::span<const Slice> slices, const ColourScale& scale);

/// Slice with a thin frame around it.
void draw_panel(cv::Mat& canvas, const cv::Rect& where, const Slice& slice,
                const ColourScale& scale, bool smooth);

/// Bar of a round length, its left end at x, about a fifth of the plot.
void draw_scale_bar(cv::Mat& canvas, int x, int y, int plot_width, Real metres_per_pixel);

/// Arrow "flow", its right end at x; nothing when the flow is normal to the axes.
void draw_flow_arrow(cv::Mat& canvas, int x, int y, const std::array<int, 2>& axes,
                     BoxFace flow_to);

/// @throws RunError  when values and grain do not have the size of the slice
void require_whole(const Slice& slice);

[[nodiscard]] Picture to_picture(const cv::Mat& canvas);

}  // namespace porefines::report
