// SPDX-License-Identifier: MPL-2.0
#include "report/draw_run.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "core/error.hpp"
#include "report/draw_run_parts.hpp"

namespace porefines::report {

Rgb colour_of(analysis::Fate fate) {
  switch (fate) {
    case analysis::Fate::piping:
      return {250, 200, 40};
    case analysis::Fate::bridging:
      return {214, 40, 57};
    case analysis::Fate::clogged:
      return {150, 50, 190};
    case analysis::Fate::resting:
      break;
  }
  return {110, 110, 116};
}

Picture draw_chip(const Slice& flow, const RunView& view, const RunStyle& style) {
  require_whole(flow);
  const PictureStyle base = base_style(style, "speed", "m/s");
  const ColourScale scale = colour_scale({&flow, 1}, base);
  const Real size = std::max(flow.width * flow.cell_width, flow.height * flow.cell_height);
  const Real per_pixel = size / style.longer_side;
  const auto pixels = [&](Real metres) {
    return std::max(8, static_cast<int>(std::lround(metres / per_pixel)));
  };
  cv::Rect plot;
  cv::Mat canvas =
      start_canvas(pixels(flow.width * flow.cell_width), pixels(flow.height * flow.cell_height),
                   base, scale, exceeds({&flow, 1}, scale), plot);
  draw_panel(canvas, plot, flow, scale, true);
  const Panel panel{plot, flow.axes, view.low, per_pixel};
  draw_fines(canvas, panel, in_order_of_sight(view.fines, 2, true), style.colour, scale);
  draw_chords(canvas, panel, view.clogged);
  draw_footer(canvas, plot, plot.y + plot.height + layout::footer / 2, per_pixel, view, style,
              flow.axes);
  return to_picture(canvas);
}

SliceValues mean_along(std::span<const float> values, const Int3& cells, const Vec3& spacing,
                       int axis) {
  if (values.size() != static_cast<std::size_t>(product(cells))) {
    throw RunError(fmt::format("picture: {} values for {} x {} x {} cells", values.size(), cells[0],
                               cells[1], cells[2]));
  }
  SliceValues slice = mid_slice(values, {}, cells, spacing, axis);
  const std::array<Index, 3> stride{1, cells[0], Index{cells[0]} * cells[1]};
  const auto [right, up] = slice.shape.axes;
  std::size_t to = 0;
  for (int b = 0; b < slice.shape.height; ++b) {
    for (int a = 0; a < slice.shape.width; ++a, ++to) {
      Real sum = 0;
      for (int c = 0; c < cells[axis]; ++c) {
        sum += static_cast<Real>(values[static_cast<std::size_t>(
            a * stride[right] + b * stride[up] + c * stride[axis])]);
      }
      slice.values[to] = static_cast<float>(sum / cells[axis]);
    }
  }
  return slice;
}

}  // namespace porefines::report
