// SPDX-License-Identifier: MPL-2.0
// A run in a volume, as a drawing in three views: x-y at the lower left, x-z above, z-y to the right.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/draw_run_parts.hpp"
#include "report/picture_text.hpp"
#include "report/picture_ticks.hpp"

namespace porefines::report {
namespace {

constexpr int headroom = 30;  ///< [pixels] for the caption of the uppermost view
constexpr int between = 44;   ///< [pixels] from one view to the next, with its caption

/// The canvas with the three planes painted; panels normal to x, y, z.
struct ThreeViews {
  cv::Mat canvas;
  std::array<Panel, 3> panels;
  ColourScale scale;
};

ThreeViews start_views(const std::array<Slice, 3>& slices, const RunView& view,
                       const PictureStyle& base, const ColourScale& scale, bool beyond) {
  for (const Slice& slice : slices) {
    require_whole(slice);
  }
  const Slice& xy = slices[2];
  const Real x = xy.width * xy.cell_width;
  const Real y = xy.height * xy.cell_height;
  const Real z = slices[0].width * slices[0].cell_width;
  const Real per_pixel = std::max(x + z, y + z) / (base.longer_side - between);
  const auto pixels = [&](Real metres) {
    return std::max(8, static_cast<int>(std::lround(metres / per_pixel)));
  };
  cv::Rect plot;
  ThreeViews views;
  views.scale = scale;
  views.canvas =
      start_canvas(pixels(x) + between + pixels(z), pixels(z) + between + pixels(y) + headroom,
                   base, scale, beyond, plot);
  const cv::Rect top(plot.x, plot.y + headroom, pixels(x), pixels(z));
  const cv::Rect front(plot.x, top.y + top.height + between, pixels(x), pixels(y));
  const cv::Rect side(front.x + front.width + between, front.y, pixels(z), pixels(y));
  const std::array<cv::Rect, 3> where{side, top, front};
  for (std::size_t a = 0; a < 3; ++a) {
    views.panels[a] = {where[a], slices[a].axes, view.low, per_pixel};
    draw_panel(views.canvas, where[a], slices[a], scale, true);
  }
  return views;
}

void draw_caption(cv::Mat& canvas, const Panel& panel, const std::string& text) {
  draw_text(canvas, text, panel.where.x, panel.where.y - 10,
            {.height = 12, .colour = {90, 92, 96}});
}

/// From zero to the fastest, or what the style says.
ColourScale scale_of(const std::vector<DrawnFine>& fines, const RunStyle& style) {
  if (style.range) {
    return {(*style.range)[0], (*style.range)[1], false, Colormap::speed};
  }
  Real fastest = 0;
  for (const DrawnFine& fine : fines) {
    fastest = std::max(fastest, fine.speed);
  }
  return {0, fastest > 0 ? fastest : 1, false, Colormap::speed};
}

Picture finish(ThreeViews& views, const RunView& view, const RunStyle& style) {
  const Panel& front = views.panels[2];
  cv::Rect plot = front.where;
  plot.width = views.panels[0].where.x + views.panels[0].where.width - plot.x;
  draw_footer(views.canvas, plot, plot.y + plot.height + 34, front.per_pixel, view, style,
              front.axes);
  return to_picture(views.canvas);
}

}  // namespace

Picture draw_planes(const std::array<Slice, 3>& flow, const RunView& view, const RunStyle& style) {
  const PictureStyle base = base_style(style, "speed", "m/s");
  const ColourScale scale = colour_scale(flow, base);
  ThreeViews views = start_views(flow, view, base, scale, exceeds(flow, scale));
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const Real position = flow[a].position;
    draw_fines(views.canvas, views.panels[a], cut_by(view.fines, axis, view.low[axis] + position),
               style.colour, views.scale);
    const DisplayUnit unit = display_unit(std::abs(position), "m");
    draw_caption(views.canvas, views.panels[a],
                 fmt::format("{} = {:.4g} {}", "xyz"[axis], position / unit.factor, unit.text));
  }
  return finish(views, view, style);
}

Picture draw_projections(const std::array<Slice, 3>& rock, const RunView& view,
                         const RunStyle& style) {
  const bool by_fate = style.colour == FineColour::fate;
  const ColourScale rocks{0, 1, false, Colormap::rock};
  const ColourScale speeds = scale_of(view.fines, style);
  const bool beyond = std::any_of(view.fines.begin(), view.fines.end(), [&](const auto& fine) {
    return speeds.position(fine.speed) > 1.01;
  });
  const PictureStyle base = by_fate ? base_style(style, "rock along the line of sight", "")
                                    : base_style(style, "speed of the fines", "m/s");
  ThreeViews views = start_views(rock, view, base, by_fate ? rocks : speeds, !by_fate && beyond);
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const Panel& panel = views.panels[a];
    draw_panel(views.canvas, panel.where, rock[a], rocks, true);
    draw_fines(views.canvas, panel, in_order_of_sight(view.fines, axis, axis == 2), style.colour,
               speeds);
    draw_chords(views.canvas, panel, view.clogged);
    draw_caption(views.canvas, panel, fmt::format("all, seen along {}", "xyz"[axis]));
  }
  return finish(views, view, style);
}

}  // namespace porefines::report
