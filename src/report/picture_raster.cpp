// SPDX-License-Identifier: MPL-2.0
#include "report/picture_raster.hpp"

#include <algorithm>
#include <array>

namespace porefines::report {
namespace {

constexpr Rgb grain_colour{203, 197, 189};
constexpr Rgb outline_colour{128, 121, 113};

/// Mean over fluid cells and how much of the pixel is fluid.
struct Sample {
  Real value = 0;
  Real fluid = 0;

  void add(const Slice& slice, int i, int j, Real weight) {
    const std::size_t cell = static_cast<std::size_t>(j) * slice.width + i;
    if (slice.grain.empty() || slice.grain[cell] == 0) {
      value += weight * slice.values[cell];
      fluid += weight;
    }
  }
};

/// Cells and weights that a pixel sees along one axis.
struct Footprint {
  int first = 0;
  int last = 0;            ///< inclusive
  Real last_weight = 0.5;  ///< of two cells, when bilinear
};

Footprint footprint(int pixel, int pixels, int cells, bool smooth) {
  const Real from = static_cast<Real>(pixel) * cells / pixels;
  const Real to = static_cast<Real>(pixel + 1) * cells / pixels;
  if (pixels < cells) {
    return {
        static_cast<int>(from),
        std::min(cells - 1, std::max(static_cast<int>(from), static_cast<int>(std::ceil(to)) - 1)),
        0};
  }
  const Real centre = 0.5 * (from + to);
  if (!smooth) {
    const int cell = std::min(cells - 1, static_cast<int>(centre));
    return {cell, cell, 0};
  }
  const Real place = std::clamp(centre - 0.5, 0.0, static_cast<Real>(cells - 1));
  const int first = std::min(static_cast<int>(place), std::max(0, cells - 2));
  return {first, std::min(first + 1, cells - 1), place - first};
}

Real weight(const Footprint& f, int cell, bool bilinear) {
  if (!bilinear || f.first == f.last) {
    return 1.0 / (f.last - f.first + 1);
  }
  return cell == f.first ? 1 - f.last_weight : f.last_weight;
}

cv::Vec3b blend(const Rgb& a, const Rgb& b, Real t) {
  cv::Vec3b out;
  for (int c = 0; c < 3; ++c) {
    out[c] = static_cast<std::uint8_t>(std::lround(a[c] + (b[c] - a[c]) * t));
  }
  return out;
}

cv::Vec3b pixel_colour(const Sample& sample, const ColourScale& scale, Real pixels_per_cell) {
  if (!(sample.fluid > 0)) {
    return blend(grain_colour, grain_colour, 0);
  }
  const Rgb fluid = colour(scale.colormap, scale.position(sample.value / sample.fluid));
  if (pixels_per_cell <= 1) {
    return blend(grain_colour, fluid, sample.fluid);
  }
  // Distance to the outline in pixels: the fluid fraction changes by one over a cell.
  const Real distance = (sample.fluid - 0.5) * pixels_per_cell;
  const cv::Vec3b base = blend(grain_colour, fluid, std::clamp(distance + 0.5, 0.0, 1.0));
  // Away from grains there is no outline, however few pixels a cell has.
  const Real line = sample.fluid > 1 - 1e-9 ? 0 : std::clamp(1.4 - std::abs(distance), 0.0, 1.0);
  return blend({base[0], base[1], base[2]}, outline_colour, 0.85 * line);
}

}  // namespace

void paint_slice(cv::Mat& canvas, const cv::Rect& where, const Slice& slice,
                 const ColourScale& scale, bool smooth) {
  const bool wide = where.width >= slice.width;
  const bool high = where.height >= slice.height;
  const Real pixels_per_cell =
      wide && high && smooth
          ? std::sqrt(static_cast<Real>(where.width) / slice.width * where.height / slice.height)
          : 0;
  for (int row = 0; row < where.height; ++row) {
    const Footprint y = footprint(where.height - 1 - row, where.height, slice.height, smooth);
    for (int column = 0; column < where.width; ++column) {
      const Footprint x = footprint(column, where.width, slice.width, smooth);
      Sample sample;
      for (int j = y.first; j <= y.last; ++j) {
        for (int i = x.first; i <= x.last; ++i) {
          sample.add(slice, i, j, weight(x, i, wide) * weight(y, j, high));
        }
      }
      canvas.at<cv::Vec3b>(where.y + row, where.x + column) =
          pixel_colour(sample, scale, pixels_per_cell);
    }
  }
}

}  // namespace porefines::report
