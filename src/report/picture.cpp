// SPDX-License-Identifier: MPL-2.0
#include "report/picture.hpp"

#include <algorithm>
#include <cmath>

#include "io/png.hpp"
#include "report/picture_parts.hpp"

namespace porefines::report {
namespace {

/// Pixels of the plot: an integer factor when cells are enlarged and square.
cv::Size plot_size(const Slice& slice, int longer_side) {
  const Real width = slice.width * slice.cell_width;
  const Real height = slice.height * slice.cell_height;
  Real per_metre = longer_side / std::max(width, height);
  const Real enlargement = per_metre * slice.cell_width;
  if (enlargement > 0.75) {
    per_metre = std::max(1.0, std::round(enlargement)) / slice.cell_width;
  }
  return {std::max(1, static_cast<int>(std::lround(width * per_metre))),
          std::max(1, static_cast<int>(std::lround(height * per_metre)))};
}

}  // namespace

Picture draw_slice(const Slice& slice, const PictureStyle& style) {
  require_whole(slice);
  const std::span<const Slice> one(&slice, 1);
  const ColourScale scale = colour_scale(one, style);
  const cv::Size size = plot_size(slice, style.longer_side);
  cv::Rect plot;
  cv::Mat canvas = start_canvas(size.width, size.height, style, scale, exceeds(one, scale), plot);
  draw_panel(canvas, plot, slice, scale, style.smooth);
  const int below = plot.y + plot.height + 34;
  draw_scale_bar(canvas, plot.x, below, plot.width, slice.width * slice.cell_width / plot.width);
  if (style.flow_to) {
    draw_flow_arrow(canvas, plot.x + plot.width, below, slice.axes, *style.flow_to);
  }
  return to_picture(canvas);
}

void write_picture(const std::string& path, const Picture& picture,
                   const io::Provenance& provenance, const std::string& title) {
  io::write_png(path, {picture.width, picture.height, 3, picture.rgb}, provenance, title);
}

}  // namespace porefines::report
