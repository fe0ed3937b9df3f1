// SPDX-License-Identifier: MPL-2.0
#include "report/draw_chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "report/picture_parts.hpp"
#include "report/picture_text.hpp"
#include "report/picture_ticks.hpp"

namespace porefines::report {
namespace {

const cv::Scalar ink(40, 42, 46);
const cv::Scalar pale(226, 229, 233);
constexpr int wide = 900;
constexpr int high = 560;
const cv::Rect plot(124, 70, wide - 124 - 40, high - 70 - 84);
constexpr std::array<Rgb, 8> inks{{{38, 98, 152},
                                   {196, 78, 44},
                                   {52, 132, 88},
                                   {126, 82, 152},
                                   {120, 112, 100},
                                   {30, 158, 170},
                                   {190, 142, 30},
                                   {196, 82, 138}}};

cv::Scalar scalar(const Rgb& c) {
  return {static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])};
}

/// One axis: from SI to pixels.
struct Axis {
  Real low = std::numeric_limits<Real>::max();
  Real high = std::numeric_limits<Real>::lowest();
  bool logarithmic = false;
  int from = 0;
  int to = 1;

  void include(Real value) {
    if (std::isfinite(value) && (!logarithmic || value > 0)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  [[nodiscard]] bool shows(Real value) const {
    return std::isfinite(value) && (!logarithmic || value > 0);
  }
  [[nodiscard]] int at(Real value) const {
    const Real share =
        logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
    return from + static_cast<int>(std::lround(std::clamp(share, -1.0, 2.0) * (to - from)));
  }
};

/// A little room around the values; never an empty range.
void settle(Axis& axis, bool from_zero) {
  if (axis.low > axis.high) {
    axis.low = axis.logarithmic ? 1 : 0;
    axis.high = axis.logarithmic ? 10 : 1;
  }
  if (axis.logarithmic) {
    axis.low /= 1.2;
    axis.high *= 1.2;
    return;
  }
  if (from_zero && axis.low >= 0) {
    axis.low = 0;
  }
  Real room = 0.06 * (axis.high - axis.low);
  room = room > 0 ? room : axis.high != 0 ? 0.1 * std::abs(axis.high) : 1;
  axis.high += room;
  axis.low -= from_zero && axis.low == 0 ? 0 : room;
}

struct Tick {
  Real value;
  std::string label;
};

std::vector<Tick> ticks_of(const Axis& axis, const DisplayUnit& unit, int wanted) {
  std::vector<Tick> ticks;
  if (axis.logarithmic) {
    const bool many = axis.high > 100 * axis.low;
    for (int decade = static_cast<int>(std::floor(std::log10(axis.low / unit.factor)));
         decade <= static_cast<int>(std::ceil(std::log10(axis.high / unit.factor))); ++decade) {
      for (const int digit : {1, 2, 5}) {
        const Real shown = digit * std::pow(10.0, decade);
        const Real value = shown * unit.factor;
        if (value >= axis.low && value <= axis.high && (digit == 1 || !many)) {
          const bool plain = decade >= -3 && decade < 5;
          ticks.push_back(
              {value, plain ? fmt::format("{:g}", shown) : fmt::format("{}e{}", digit, decade)});
        }
      }
    }
    return ticks;
  }
  const auto values = nice_ticks(axis.low / unit.factor, axis.high / unit.factor, wanted);
  const Real step = values.size() > 1 ? values[1] - values[0] : 1;
  for (const Real value : values) {
    ticks.push_back({value * unit.factor, tick_text(value, step)});
  }
  return ticks;
}

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : fmt::format("{} ({})", name, unit);
}

void draw_axes(cv::Mat& canvas, const Axis& x, const Axis& y, const ChartStyle& style) {
  const auto unit_of = [](const Axis& axis, const std::string& unit) {
    return unit.empty() ? DisplayUnit{1, ""}
                        : display_unit(std::max(std::abs(axis.low), std::abs(axis.high)), unit);
  };
  const DisplayUnit x_unit = unit_of(x, style.x_unit);
  const DisplayUnit y_unit = unit_of(y, style.y_unit);
  const int bottom = plot.y + plot.height;
  for (const Tick& tick : ticks_of(y, y_unit, 5)) {
    cv::line(canvas, {plot.x, y.at(tick.value)}, {plot.x + plot.width, y.at(tick.value)}, pale, 1);
    draw_text(canvas, tick.label, plot.x - 10,
              y.at(tick.value) + static_cast<int>(layout::text / 2),
              {.height = layout::text, .anchor = Anchor::right});
  }
  for (const Tick& tick : ticks_of(x, x_unit, 7)) {
    cv::line(canvas, {x.at(tick.value), bottom}, {x.at(tick.value), bottom + 6}, ink, 1);
    draw_text(canvas, tick.label, x.at(tick.value), bottom + 28,
              {.height = layout::text, .anchor = Anchor::centre});
  }
  cv::line(canvas, {plot.x, bottom}, {plot.x + plot.width, bottom}, ink, 1);
  const TextStyle name{.height = layout::text + 1, .anchor = Anchor::centre};
  draw_text(canvas, with_unit(style.x_name, x_unit.text), plot.x + plot.width / 2, high - 24, name);
  TextStyle upwards = name;
  upwards.upwards = true;
  draw_text(canvas, with_unit(style.y_name, y_unit.text), 30, plot.y + plot.height / 2, upwards);
}

void draw_band(cv::Mat& canvas, const Curve& c, const Axis& x, const Axis& y, const Rgb& colour) {
  cv::Mat layer = canvas.clone();
  for (std::size_t i = 0; i + 1 < c.x.size() && i + 1 < c.low.size(); ++i) {
    const bool shown = y.shows(c.low[i]) && y.shows(c.high[i]) && y.shows(c.low[i + 1]) &&
                       y.shows(c.high[i + 1]) && x.shows(c.x[i]);
    if (shown) {
      const std::vector<cv::Point> part{{x.at(c.x[i]), y.at(c.low[i])},
                                        {x.at(c.x[i]), y.at(c.high[i])},
                                        {x.at(c.x[i + 1]), y.at(c.high[i + 1])},
                                        {x.at(c.x[i + 1]), y.at(c.low[i + 1])}};
      cv::fillConvexPoly(layer, part, scalar(colour));
    }
  }
  cv::addWeighted(layer, 0.25, canvas, 0.75, 0, canvas);
}

void draw_bar(cv::Mat& canvas, const Curve& c, std::size_t i, const Axis& x, const Axis& y,
              const Rgb& colour) {
  const Real half = c.x.size() > 1 ? 0.5 * (c.x[1] - c.x[0]) : 0.5;
  const cv::Point a(x.at(c.x[i] - half) + 1, y.at(c.y[i]));
  const cv::Point b(x.at(c.x[i] + half) - 1, y.at(y.low));
  if (a.y < b.y) {
    cv::rectangle(canvas, a, b, scalar(colour), cv::FILLED);
  }
}

void draw_curve(cv::Mat& canvas, const Curve& c, const Axis& x, const Axis& y, const Rgb& colour) {
  for (std::size_t i = 0; i < std::min(c.x.size(), c.y.size()); ++i) {
    if (!x.shows(c.x[i]) || !y.shows(c.y[i])) {
      continue;
    }
    const cv::Point here(x.at(c.x[i]), y.at(c.y[i]));
    if (c.look == Curve::Look::bars) {
      draw_bar(canvas, c, i, x, y, colour);
    } else if (c.look == Curve::Look::points) {
      cv::circle(canvas, here, 4, scalar(colour), cv::FILLED, cv::LINE_AA);
    } else if (i > 0 && x.shows(c.x[i - 1]) && y.shows(c.y[i - 1]) &&
               (c.look == Curve::Look::line || i % 2 == 0)) {
      cv::line(canvas, {x.at(c.x[i - 1]), y.at(c.y[i - 1])}, here, scalar(colour), 2, cv::LINE_AA);
    }
  }
}

constexpr int legend_line = 25;

/// Of all named curves together.
cv::Size legend_size(const std::vector<Curve>& curves) {
  cv::Size size(0, 0);
  for (const Curve& c : curves) {
    if (!c.name.empty()) {
      size.width = std::max(size.width, text_width(c.name, {.height = layout::text}) + 8);
      size.height += legend_line;
    }
  }
  return size;
}

/// The corner through which the least of the curves passes; in doubt above, and on the left.
cv::Rect quiet_corner(const std::vector<Curve>& curves, const Axis& x, const Axis& y) {
  constexpr int steps = 16;  // looked at between two points
  const cv::Size size = legend_size(curves);
  const int left = plot.x + 10;
  const int right = plot.x + plot.width - 12 - size.width;
  const int upper = plot.y + 2;
  const int lower = plot.y + plot.height - 6 - size.height;
  cv::Rect best;
  int fewest = std::numeric_limits<int>::max();
  for (const cv::Point corner :
       {cv::Point(left, upper), {right, upper}, {left, lower}, {right, lower}}) {
    const cv::Rect box(corner, size);
    int inside = 0;
    for (const Curve& c : curves) {
      for (std::size_t i = 1; i < std::min(c.x.size(), c.y.size()); ++i) {
        if (!x.shows(c.x[i]) || !y.shows(c.y[i]) || !x.shows(c.x[i - 1]) || !y.shows(c.y[i - 1])) {
          continue;
        }
        const cv::Point from(x.at(c.x[i - 1]), y.at(c.y[i - 1]));
        const cv::Point way = cv::Point(x.at(c.x[i]), y.at(c.y[i])) - from;
        for (int k = 0; k <= steps; ++k) {
          inside += box.contains(from + way * k / steps) ? 1 : 0;
        }
      }
    }
    if (inside < fewest) {
      fewest = inside;
      best = box;
    }
  }
  return best;
}

void draw_legend(cv::Mat& canvas, const std::vector<Curve>& curves, const cv::Rect& box) {
  const bool at_left = box.x < plot.x + plot.width / 2;
  int y = box.y + 18;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    if (curves[k].name.empty()) {
      continue;
    }
    const TextStyle style{.height = layout::text, .colour = inks[k % inks.size()]};
    const int width = text_width(curves[k].name, style);
    const int left = at_left ? box.x + 4 : box.x + box.width - 4 - width;
    cv::rectangle(canvas, cv::Rect(left - 4, y - 18, width + 8, 24), cv::Scalar(255, 255, 255),
                  cv::FILLED);
    draw_text(canvas, curves[k].name, left, y, style);
    y += legend_line;
  }
}

}  // namespace

Picture draw_chart(const std::vector<Curve>& curves, const ChartStyle& style) {
  Axis x{.logarithmic = style.logarithmic, .from = plot.x, .to = plot.x + plot.width};
  Axis y{.logarithmic = style.logarithmic, .from = plot.y + plot.height, .to = plot.y};
  for (const Curve& c : curves) {
    for (const auto* values : {&c.y, &c.low, &c.high}) {
      std::for_each(values->begin(), values->end(), [&](Real v) { y.include(v); });
    }
    std::for_each(c.x.begin(), c.x.end(), [&](Real v) { x.include(v); });
    if (c.look == Curve::Look::bars && c.x.size() > 1) {
      x.include(c.x.front() - 0.5 * (c.x[1] - c.x[0]));
      x.include(c.x.back() + 0.5 * (c.x[1] - c.x[0]));
    }
  }
  settle(x, x.low >= 0 && x.low < 0.2 * x.high);
  settle(y, style.from_zero);
  cv::Mat canvas(high, wide, CV_8UC3, cv::Scalar(255, 255, 255));
  const TextStyle title{.height = layout::title_text, .bold = true};
  draw_text(canvas, style.title, plot.x, 42,
            fitted(title, style.title, canvas.cols - plot.x - layout::margin));
  draw_axes(canvas, x, y, style);
  for (std::size_t k = 0; k < curves.size(); ++k) {
    draw_band(canvas, curves[k], x, y, inks[k % inks.size()]);
  }
  for (std::size_t k = 0; k < curves.size(); ++k) {
    draw_curve(canvas, curves[k], x, y, inks[k % inks.size()]);
  }
  draw_legend(canvas, curves, quiet_corner(curves, x, y));
  return to_picture(canvas);
}

}  // namespace porefines::report
