// SPDX-License-Identifier: MPL-2.0
#include "report/draw_run_parts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "report/picture_text.hpp"

namespace porefines::report {
namespace {

constexpr int subpixel = 4;  ///< bits: discs are placed to a sixteenth of a pixel
constexpr int one = 1 << subpixel;

cv::Scalar scalar(const Rgb& c, Real shade = 1) {
  return {c[0] * shade, c[1] * shade, c[2] * shade};
}

cv::Point place(const Panel& panel, const Vec3& x) {
  const Real right = (x[panel.axes[0]] - panel.low[panel.axes[0]]) / panel.per_pixel;
  const Real up = (x[panel.axes[1]] - panel.low[panel.axes[1]]) / panel.per_pixel;
  return {static_cast<int>(std::lround((right - 0.5) * one)),
          static_cast<int>(std::lround((panel.where.height - up - 0.5) * one))};
}

/// A disc with a dark rim, and a white one inside where the ground may be as dark as the disc.
/// Very small ones are drawn as a dot of two pixels.
void draw_disc(cv::Mat& area, const cv::Point& centre, int radius, const Rgb& colour, bool white) {
  const int least = std::max(one, radius);
  const int rim = std::clamp(least / 5, one / 2, 2 * one);
  const auto circle = [&](int r, const cv::Scalar& c) {
    cv::circle(area, centre, std::max(one / 2, r), c, cv::FILLED, cv::LINE_AA, subpixel);
  };
  circle(least, scalar(colour, 0.35));
  if (white && least > 3 * rim) {
    circle(least - rim, {255, 255, 255});
    circle(least - 2 * rim, scalar(colour));
  } else {
    circle(least - rim, scalar(colour));
  }
}

}  // namespace

PictureStyle base_style(const RunStyle& style, const std::string& quantity,
                        const std::string& unit) {
  return {.title = style.title,
          .quantity = quantity,
          .unit = unit,
          .colormap = style.colour == FineColour::speed ? Colormap::speed : Colormap::pale,
          .range = style.range,
          .flow_to = style.flow_to,
          .longer_side = style.longer_side};
}

std::vector<DrawnFine> in_order_of_sight(std::vector<DrawnFine> fines, int axis, bool from_high) {
  const Real sign = from_high ? 1 : -1;
  std::stable_sort(fines.begin(), fines.end(), [&](const DrawnFine& a, const DrawnFine& b) {
    return sign * a.centre[axis] < sign * b.centre[axis];
  });
  return fines;
}

std::vector<DrawnFine> cut_by(const std::vector<DrawnFine>& fines, int axis, Real place) {
  std::vector<DrawnFine> cut;
  for (DrawnFine fine : fines) {
    const Real off = fine.centre[axis] - place;
    if (std::abs(off) < fine.radius) {
      fine.radius = std::sqrt(fine.radius * fine.radius - off * off);
      cut.push_back(fine);
    }
  }
  return cut;
}

void draw_fines(cv::Mat& canvas, const Panel& panel, const std::vector<DrawnFine>& fines,
                FineColour colouring, const ColourScale& speeds) {
  cv::Mat area = canvas(panel.where);
  for (const DrawnFine& fine : fines) {
    const Rgb c = colouring == FineColour::fate
                      ? colour_of(fine.fate)
                      : colour(speeds.colormap, speeds.position(fine.speed));
    draw_disc(area, place(panel, fine.centre),
              static_cast<int>(std::lround(fine.radius / panel.per_pixel * one)), c,
              colouring == FineColour::speed);
  }
}

void draw_chords(cv::Mat& canvas, const Panel& panel,
                 const std::vector<std::array<Vec3, 2>>& chords) {
  cv::Mat area = canvas(panel.where);
  const int thick = std::max(3, panel.where.width / 400);
  for (const auto& [from, to] : chords) {
    const cv::Point a = place(panel, from);
    const cv::Point b = place(panel, to);
    cv::line(area, a, b, cv::Scalar(255, 255, 255), thick + 3, cv::LINE_AA, subpixel);
    cv::line(area, a, b, cv::Scalar(0, 0, 0), thick, cv::LINE_AA, subpixel);
  }
}

void draw_footer(cv::Mat& canvas, const cv::Rect& plot, int y, Real per_pixel, const RunView& view,
                 const RunStyle& style, const std::array<int, 2>& axes) {
  draw_scale_bar(canvas, plot.x, y, plot.width, per_pixel);
  if (style.flow_to) {
    draw_flow_arrow(canvas, plot.x + plot.width, y, axes, *style.flow_to);
  }
  if (style.colour != FineColour::fate) {
    return;
  }
  const TextStyle text{.height = layout::text};
  int x = plot.x + plot.width * 2 / 5;
  for (const auto fate : {analysis::Fate::piping, analysis::Fate::bridging, analysis::Fate::clogged,
                          analysis::Fate::resting}) {
    const auto count = std::count_if(view.fines.begin(), view.fines.end(),
                                     [&](const DrawnFine& fine) { return fine.fate == fate; });
    const std::string label = fmt::format("{} {}", count, name_of(fate));
    draw_disc(canvas, {x * one, y * one}, 8 * one, colour_of(fate), false);
    draw_text(canvas, label, x + 16, y + static_cast<int>(layout::text / 2), text);
    x += 16 + text_width(label, text) + 34;
  }
}

}  // namespace porefines::report
