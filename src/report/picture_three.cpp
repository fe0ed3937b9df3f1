// SPDX-License-Identifier: MPL-2.0
// Three views of a volume.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "report/picture.hpp"
#include "report/picture_parts.hpp"
#include "report/picture_text.hpp"
#include "report/picture_ticks.hpp"

namespace porefines::report {
namespace {

constexpr int headroom = 30;  ///< [pixels] for the caption of the uppermost view
constexpr int between = 44;   ///< [pixels] from one view to the next, with its caption

void draw_caption(cv::Mat& canvas, const cv::Rect& panel, const Slice& slice) {
  const int normal = 3 - slice.axes[0] - slice.axes[1];
  const DisplayUnit unit = display_unit(slice.position, "m");
  draw_text(canvas,
            fmt::format("{} = {:.4g} {}", "xyz"[normal], slice.position / unit.factor, unit.text),
            panel.x, panel.y - 10, {.height = 12, .colour = {90, 92, 96}});
}

}  // namespace

Slice SliceValues::view() const {
  Slice slice = shape;
  slice.values = values;
  slice.grain = grain;
  return slice;
}

SliceValues mid_slice(std::span<const float> values, std::span<const std::uint8_t> grain,
                      const Int3& cells, const Vec3& spacing, int axis) {
  const auto count = static_cast<std::size_t>(product(cells));
  if (values.size() != count || (!grain.empty() && grain.size() != count)) {
    throw RunError(fmt::format("picture: {} values and {} grain marks for {} x {} x {} cells",
                               values.size(), grain.size(), cells[0], cells[1], cells[2]));
  }
  // To the right and up, as in a drawing in three views.
  const std::array<int, 2> axes = axis == 2   ? std::array{0, 1}
                                  : axis == 1 ? std::array{0, 2}
                                              : std::array{2, 1};
  SliceValues slice;
  Int3 cell{};
  cell[axis] = cells[axis] / 2;
  slice.shape.width = cells[axes[0]];
  slice.shape.height = cells[axes[1]];
  slice.shape.cell_width = spacing[axes[0]];
  slice.shape.cell_height = spacing[axes[1]];
  slice.shape.axes = axes;
  slice.shape.position = (cell[axis] + 0.5) * spacing[axis];
  for (cell[axes[1]] = 0; cell[axes[1]] < cells[axes[1]]; ++cell[axes[1]]) {
    for (cell[axes[0]] = 0; cell[axes[0]] < cells[axes[0]]; ++cell[axes[0]]) {
      const auto at =
          static_cast<std::size_t>(cell[0] + cells[0] * (cell[1] + Index{cells[1]} * cell[2]));
      slice.values.push_back(values[at]);
      if (!grain.empty()) {
        slice.grain.push_back(grain[at]);
      }
    }
  }
  return slice;
}

Picture draw_three_slices(const std::array<Slice, 3>& slices, const PictureStyle& style) {
  const auto& [zy, xz, xy] = slices;
  for (const Slice& slice : slices) {
    require_whole(slice);
  }
  const Real x = xy.width * xy.cell_width;
  const Real y = xy.height * xy.cell_height;
  const Real z = zy.width * zy.cell_width;
  const Real per_metre = (style.longer_side - between) / std::max(x + z, y + z);
  const auto pixels = [&](Real metres) {
    return std::max(8, static_cast<int>(std::lround(metres * per_metre)));
  };
  const ColourScale scale = colour_scale(slices, style);
  cv::Rect plot;
  cv::Mat canvas =
      start_canvas(pixels(x) + between + pixels(z), pixels(z) + between + pixels(y) + headroom,
                   style, scale, exceeds(slices, scale), plot);
  const cv::Rect top(plot.x, plot.y + headroom, pixels(x), pixels(z));
  const cv::Rect front(plot.x, top.y + top.height + between, pixels(x), pixels(y));
  const cv::Rect side(front.x + front.width + between, front.y, pixels(z), pixels(y));
  const std::array<cv::Rect, 3> panels{side, top, front};
  for (std::size_t i = 0; i < 3; ++i) {
    draw_panel(canvas, panels[i], slices[i], scale, style.smooth);
    draw_caption(canvas, panels[i], slices[i]);
  }
  const int below = front.y + front.height + 34;
  draw_scale_bar(canvas, front.x, below, front.width, x / front.width);
  if (style.flow_to) {
    draw_flow_arrow(canvas, front.x + front.width, below, xy.axes, *style.flow_to);
  }
  return to_picture(canvas);
}

}  // namespace porefines::report
