// SPDX-License-Identifier: MPL-2.0
#include "report/draw_histogram.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "report/picture_parts.hpp"
#include "report/picture_text.hpp"
#include "report/picture_ticks.hpp"

namespace porefines::report {
namespace {

const cv::Scalar ink(40, 42, 46);
const cv::Scalar pale(226, 229, 233);
const cv::Scalar bar_colour(96, 140, 178);
constexpr int wide = 900;
constexpr int high = 560;
const cv::Rect plot(96, 70, wide - 96 - 40, high - 70 - 84);

struct Axes {
  Real right;  ///< SI at the right end; the left end is 0
  Real top;    ///< share at the upper end

  [[nodiscard]] int x(Real value) const {
    return plot.x + static_cast<int>(std::lround(value / right * plot.width));
  }
  [[nodiscard]] int y(Real share) const {
    return plot.y + plot.height - static_cast<int>(std::lround(share / top * plot.height));
  }
};

void draw_axes(cv::Mat& canvas, const Axes& axes, const HistogramStyle& style) {
  const DisplayUnit unit = display_unit(axes.right, style.unit);
  const TextStyle middle{.height = layout::text, .anchor = Anchor::centre};
  const auto along = nice_ticks(0, axes.right / unit.factor, 7);
  for (const Real tick : along) {
    const int x = axes.x(tick * unit.factor);
    cv::line(canvas, {x, plot.y + plot.height}, {x, plot.y + plot.height + 6}, ink, 1);
    draw_text(canvas, tick_text(tick, along[1] - along[0]), x, plot.y + plot.height + 28, middle);
  }
  const auto up = nice_ticks(0, 100 * axes.top, 5);
  for (const Real tick : up) {
    const int y = axes.y(tick / 100);
    cv::line(canvas, {plot.x, y}, {plot.x + plot.width, y}, pale, 1);
    draw_text(canvas, tick_text(tick, up[1] - up[0]), plot.x - 10,
              y + static_cast<int>(layout::text / 2),
              {.height = layout::text, .anchor = Anchor::right});
  }
  draw_text(canvas, fmt::format("{} ({})", style.quantity, unit.text), plot.x + plot.width / 2,
            high - 24, {.height = layout::text + 1, .anchor = Anchor::centre});
  draw_text(canvas, style.share + " (%)", 34, plot.y + plot.height / 2,
            {.height = layout::text + 1, .anchor = Anchor::centre, .upwards = true});
}

struct Mark {
  Real value;
  std::string name;
  Rgb colour;
};

/// Vertical lines, then their names and values beside them, one below the other.
void draw_marks(cv::Mat& canvas, const Axes& axes, const std::vector<Mark>& marks,
                const std::string& unit) {
  const DisplayUnit shown = display_unit(axes.right, unit);
  for (const Mark& mark : marks) {
    const int x = axes.x(mark.value);
    cv::line(canvas, {x, plot.y}, {x, plot.y + plot.height},
             cv::Scalar(mark.colour[0], mark.colour[1], mark.colour[2]), 2);
  }
  int y = plot.y + 18;
  for (const Mark& mark : marks) {
    const std::string text =
        fmt::format("{} {:.3g} {}", mark.name, mark.value / shown.factor, shown.text);
    const TextStyle style{.height = layout::text, .colour = mark.colour};
    const int length = text_width(text, style);
    const int x = axes.x(mark.value);
    const int left = x + 10 + length < plot.x + plot.width ? x + 8 : x - 8 - length;
    cv::rectangle(canvas, cv::Rect(left - 3, y - 18, length + 6, 23), cv::Scalar(255, 255, 255),
                  cv::FILLED);
    draw_text(canvas, text, left, y, style);
    y += 24;
  }
}

}  // namespace

Picture draw_histogram(const geom::SizeDistribution& sizes, const HistogramStyle& style) {
  cv::Mat canvas(high, wide, CV_8UC3, cv::Scalar(255, 255, 255));
  const TextStyle title{.height = layout::title_text, .bold = true};
  draw_text(canvas, style.title, plot.x, 42,
            fitted(title, style.title, canvas.cols - plot.x - layout::margin));
  if (sizes.empty()) {
    draw_text(canvas, "none found", plot.x + plot.width / 2, plot.y + plot.height / 2,
              {.height = layout::text, .anchor = Anchor::centre});
    return to_picture(canvas);
  }
  const Real last = std::max(1.05 * sizes.quantile(0.995), style.mark * 1.1);
  const auto bins = static_cast<std::size_t>(style.bins);
  std::vector<Real> share(bins, 0);
  const Real total = std::accumulate(sizes.weight.begin(), sizes.weight.end(), Real{0});
  for (std::size_t i = 0; i < sizes.size.size(); ++i) {
    const auto bin = static_cast<std::size_t>(sizes.size[i] / last * style.bins);
    share[std::min(bin, bins - 1)] += sizes.weight[i] / total;
  }
  const Axes axes{last, 1.15 * *std::max_element(share.begin(), share.end())};
  draw_axes(canvas, axes, style);
  for (std::size_t b = 0; b < bins; ++b) {
    const Real left = last * static_cast<Real>(b) / style.bins;
    const cv::Point a(axes.x(left) + 1, axes.y(share[b]));
    const cv::Point c(axes.x(left + last / style.bins) - 1, plot.y + plot.height);
    if (share[b] > 0) {
      cv::rectangle(canvas, a, c, bar_colour, cv::FILLED);
    }
  }
  cv::line(canvas, {plot.x, plot.y + plot.height}, {plot.x + plot.width, plot.y + plot.height}, ink,
           1);
  std::vector<Mark> marks{{sizes.quantile(0.5), "median", {176, 66, 46}},
                          {sizes.mean(), "mean", {60, 66, 74}}};
  if (style.mark > 0) {
    marks.push_back({style.mark, style.mark_name, {46, 120, 80}});
  }
  draw_marks(canvas, axes, marks, style.unit);
  return to_picture(canvas);
}

}  // namespace porefines::report
