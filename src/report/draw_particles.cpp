// SPDX-License-Identifier: MPL-2.0
#include "report/draw_particles.hpp"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "report/picture_parts.hpp"
#include "report/picture_ticks.hpp"

namespace porefines::report {
namespace {

constexpr Rgb pore_colour{244, 248, 251};
constexpr Rgb wall_colour{190, 172, 146};
constexpr int subpixel = 4;  ///< bits: discs are placed to a sixteenth of a pixel

cv::Scalar scalar(const Rgb& c, Real shade = 1) {
  return {c[0] * shade, c[1] * shade, c[2] * shade};
}

void paint_walls(cv::Mat& plot, const Scene& scene, Real metres_per_pixel) {
  const int right = scene.axes[0];
  const int up = scene.axes[1];
  Vec3 x = 0.5 * (scene.low + scene.high);
  for (int row = 0; row < plot.rows; ++row) {
    auto* const pixels = plot.ptr<cv::Vec3b>(row);
    x[up] = scene.high[up] - (row + 0.5) * metres_per_pixel;
    for (int column = 0; column < plot.cols; ++column) {
      x[right] = scene.low[right] + (column + 0.5) * metres_per_pixel;
      const Rgb& c = scene.solid && scene.solid(x) ? wall_colour : pore_colour;
      pixels[column] = {c[0], c[1], c[2]};
    }
  }
}

/// [0, largest value], the outermost hundredth beyond the bar.
ColourScale scale_of(const std::vector<Disc>& discs, const PictureStyle& style) {
  std::vector<Real> values;
  for (const Disc& disc : discs) {
    values.push_back(disc.value);
  }
  std::sort(values.begin(), values.end());
  const Real top = values.empty() ? 0 : values[(values.size() * 99) / 100];
  if (style.range) {
    return {(*style.range)[0], (*style.range)[1], false, style.colormap};
  }
  return {0, top > 0 ? top : 1, false, style.colormap};
}

}  // namespace

Picture draw_particles(std::vector<Disc> discs, const Scene& scene, const PictureStyle& style) {
  const int right = scene.axes[0];
  const int up = scene.axes[1];
  const int depth = 3 - right - up;
  const Vec3 size = scene.high - scene.low;
  const Real metres_per_pixel = std::max(size[right], size[up]) / style.longer_side;
  const int width = std::max(1, static_cast<int>(std::lround(size[right] / metres_per_pixel)));
  const int height = std::max(1, static_cast<int>(std::lround(size[up] / metres_per_pixel)));
  const ColourScale scale = scale_of(discs, style);
  const bool beyond = std::any_of(discs.begin(), discs.end(),
                                  [&](const Disc& disc) { return disc.value > scale.high; });
  cv::Rect plot;
  cv::Mat canvas = start_canvas(width, height, style, scale, beyond, plot);
  cv::Mat area = canvas(plot);
  paint_walls(area, scene, metres_per_pixel);
  // Along y one looks from y-, along z from above.
  const Real away = depth == 2 ? 1 : -1;
  std::stable_sort(discs.begin(), discs.end(), [&](const Disc& a, const Disc& b) {
    return away * a.centre[depth] < away * b.centre[depth];
  });
  constexpr int one = 1 << subpixel;
  for (const Disc& disc : discs) {
    const cv::Point centre(
        static_cast<int>(
            std::lround((disc.centre[right] - scene.low[right]) / metres_per_pixel * one)),
        static_cast<int>(std::lround((scene.high[up] - disc.centre[up]) / metres_per_pixel * one)));
    const int radius =
        std::max(one, static_cast<int>(std::lround(disc.radius / metres_per_pixel * one)));
    const Rgb c = colour(style.colormap, scale.position(disc.value));
    cv::circle(area, centre, radius, scalar(c, 0.6), cv::FILLED, cv::LINE_AA, subpixel);
    cv::circle(area, centre, std::max(one, radius - one), scalar(c), cv::FILLED, cv::LINE_AA,
               subpixel);
  }
  cv::rectangle(canvas, {plot.x - 1, plot.y - 1, plot.width + 2, plot.height + 2},
                cv::Scalar(40, 42, 46), 1);
  draw_scale_bar(canvas, plot.x, plot.y + plot.height + layout::footer / 2, plot.width,
                 metres_per_pixel);
  return to_picture(canvas);
}

}  // namespace porefines::report
