// SPDX-License-Identifier: MPL-2.0
#include "report/picture_parts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "core/error.hpp"
#include "report/picture_text.hpp"
#include "report/picture_ticks.hpp"

namespace porefines::report {
namespace {

const cv::Scalar ink(40, 42, 46);

/// A place on the colour bar with its label.
struct Tick {
  Real position;
  std::string label;  ///< empty: a minor tick
};

std::vector<Tick> linear_ticks(const ColourScale& scale, const DisplayUnit& unit, int bar_height) {
  std::vector<Tick> ticks;
  const Real low = scale.low / unit.factor;
  const Real high = scale.high / unit.factor;
  const auto values = nice_ticks(low, high, std::max(4, bar_height / 95));
  for (const Real value : values) {
    const Real step = values.size() > 1 ? values[1] - values[0] : std::abs(high - low);
    ticks.push_back({scale.position(value * unit.factor), tick_text(value, step)});
  }
  return ticks;
}

std::vector<Tick> decade_ticks(const ColourScale& scale) {
  std::vector<Tick> ticks;
  const int first = static_cast<int>(std::floor(std::log10(scale.low) + 1e-9));
  const int last = static_cast<int>(std::ceil(std::log10(scale.high) - 1e-9));
  for (int decade = first; decade <= last; ++decade) {
    for (int digit = 1; digit < 10; ++digit) {
      const Real position = scale.position(digit * std::pow(10.0, decade));
      if (position > -1e-9 && position < 1 + 1e-9) {
        const bool labelled = digit == 1 || (last - first <= 2 && (digit == 2 || digit == 5));
        const std::string factor = digit == 1 ? "" : fmt::format("{}×", digit);
        ticks.push_back({position, labelled ? fmt::format("{}10^{}", factor, decade) : ""});
      }
    }
  }
  return ticks;
}

void draw_colour_bar(cv::Mat& canvas, const cv::Rect& bar, const PictureStyle& style,
                     const ColourScale& scale, bool values_beyond) {
  for (int y = 0; y < bar.height; ++y) {
    const Rgb c = colour(scale.colormap, 1 - (y + 0.5) / bar.height);
    cv::line(canvas, {bar.x, bar.y + y}, {bar.x + bar.width - 1, bar.y + y},
             cv::Scalar(c[0], c[1], c[2]));
  }
  if (values_beyond) {
    const Rgb c = colour(scale.colormap, 1);
    const std::vector<cv::Point> tip{{bar.x, bar.y - 1},
                                     {bar.x + bar.width - 1, bar.y - 1},
                                     {bar.x + bar.width / 2, bar.y - 15}};
    cv::fillConvexPoly(canvas, tip, cv::Scalar(c[0], c[1], c[2]), cv::LINE_AA);
    cv::polylines(canvas, tip, true, ink, 1, cv::LINE_AA);
  }
  cv::rectangle(canvas, bar, ink, 1);

  const DisplayUnit unit =
      scale.logarithmic
          ? DisplayUnit{1, style.unit}
          : display_unit(std::max(std::abs(scale.low), std::abs(scale.high)), style.unit);
  const auto ticks =
      scale.logarithmic ? decade_ticks(scale) : linear_ticks(scale, unit, bar.height);
  const TextStyle label{.height = layout::text};
  int widest = 0;
  for (const Tick& tick : ticks) {
    const int y = bar.y + static_cast<int>(std::lround((1 - tick.position) * (bar.height - 1)));
    const int right = bar.x + bar.width;
    cv::line(canvas, {right, y}, {right + (tick.label.empty() ? 4 : 7), y}, ink, 1);
    draw_text(canvas, tick.label, right + 13, y + static_cast<int>(layout::text / 2), label);
    widest = std::max(widest, text_width(tick.label, label));
  }
  const std::string name =
      unit.text.empty() ? style.quantity : fmt::format("{} ({})", style.quantity, unit.text);
  draw_text(canvas, name, bar.x + bar.width + widest + 46, bar.y + bar.height / 2,
            {.height = layout::text + 1, .anchor = Anchor::centre, .upwards = true});
}

}  // namespace

void require_whole(const Slice& slice) {
  const auto cells = static_cast<std::size_t>(std::max(0, slice.width)) *
                     static_cast<std::size_t>(std::max(0, slice.height));
  const bool fits = cells > 0 && slice.values.size() == cells &&
                    (slice.grain.empty() || slice.grain.size() == cells) && slice.cell_width > 0 &&
                    slice.cell_height > 0;
  if (!fits) {
    throw RunError(fmt::format(
        "picture: {} values and {} grain marks for a slice of {} x {} cells of {} x {} m",
        slice.values.size(), slice.grain.size(), slice.width, slice.height, slice.cell_width,
        slice.cell_height));
  }
}

cv::Mat start_canvas(int plot_width, int plot_height, const PictureStyle& style,
                     const ColourScale& scale, bool values_beyond, cv::Rect& plot) {
  const int middle = std::max(plot_height, layout::shortest_bar);
  const TextStyle title{.height = layout::title_text, .bold = true};
  const int width = std::max(
      layout::margin + plot_width + layout::bar_gap + layout::bar_width + layout::bar_labels,
      2 * layout::margin + text_width(style.title, title));
  cv::Mat canvas(layout::title + middle + layout::footer, width, CV_8UC3,
                 cv::Scalar(255, 255, 255));
  plot = {layout::margin, layout::title + (middle - plot_height) / 2, plot_width, plot_height};
  const int tip = values_beyond ? 16 : 0;
  const cv::Rect bar(plot.x + plot_width + layout::bar_gap, layout::title + tip, layout::bar_width,
                     middle - tip);
  draw_text(canvas, style.title, layout::margin, layout::title - 22, title);
  draw_colour_bar(canvas, bar, style, scale, values_beyond);
  return canvas;
}

void draw_panel(cv::Mat& canvas, const cv::Rect& where, const Slice& slice,
                const ColourScale& scale, bool smooth) {
  paint_slice(canvas, where, slice, scale, smooth);
  cv::rectangle(canvas, {where.x - 1, where.y - 1, where.width + 2, where.height + 2}, ink, 1);
}

void draw_scale_bar(cv::Mat& canvas, int x, int y, int plot_width, Real metres_per_pixel) {
  const Real length = nice_below(0.25 * plot_width * metres_per_pixel);
  const int pixels = static_cast<int>(std::lround(length / metres_per_pixel));
  const DisplayUnit unit = display_unit(length, "m");
  cv::rectangle(canvas, cv::Rect(x, y - 3, pixels, 6), ink, cv::FILLED);
  draw_text(canvas, fmt::format("{:g} {}", length / unit.factor, unit.text), x + pixels + 14,
            y + static_cast<int>(layout::text / 2), {.height = layout::text});
}

void draw_flow_arrow(cv::Mat& canvas, int x, int y, const std::array<int, 2>& axes,
                     BoxFace flow_to) {
  constexpr int length = 74;
  const int sign = is_high(flow_to) ? 1 : -1;
  cv::Point along(0, 0);
  if (axis_of(flow_to) == axes[0]) {
    along = {sign, 0};
  } else if (axis_of(flow_to) == axes[1]) {
    along = {0, -sign};
  } else {
    return;
  }
  const int half = along.x != 0 ? length / 2 : 22;
  const cv::Point middle(x - half, y);
  const cv::Point across(-along.y, along.x);
  const cv::Point tip = middle + along * half;
  const cv::Point neck = tip - along * 15;
  cv::line(canvas, middle - along * half, neck, ink, 3, cv::LINE_AA);
  cv::fillConvexPoly(canvas, std::vector<cv::Point>{tip, neck + across * 7, neck - across * 7}, ink,
                     cv::LINE_AA);
  draw_text(canvas, "flow", x - (along.x != 0 ? length : 34) - 14,
            y + static_cast<int>(layout::text / 2),
            {.height = layout::text, .anchor = Anchor::right});
}

Picture to_picture(const cv::Mat& canvas) {
  return {canvas.cols, canvas.rows, {canvas.datastart, canvas.dataend}};
}

}  // namespace porefines::report
