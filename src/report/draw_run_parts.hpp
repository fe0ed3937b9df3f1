// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "report/draw_run.hpp"
#include "report/picture_parts.hpp"

namespace porefines::report {

/// Where a plane lies on the canvas.
struct Panel {
  cv::Rect where;
  std::array<int, 2> axes;
  Vec3 low;        ///< [m] its lower left corner
  Real per_pixel;  ///< [m]

  [[nodiscard]] int normal() const { return 3 - axes[0] - axes[1]; }
};

/// Style of the flow behind the fines.
[[nodiscard]] PictureStyle base_style(const RunStyle& style, const std::string& quantity,
                                      const std::string& unit);

/// The farthest first; one looks along the axis from its high end, or from its low end.
[[nodiscard]] std::vector<DrawnFine> in_order_of_sight(std::vector<DrawnFine> fines, int axis,
                                                       bool from_high);

/// Those that a plane cuts, with the radius of the cut.
[[nodiscard]] std::vector<DrawnFine> cut_by(const std::vector<DrawnFine>& fines, int axis,
                                            Real place);

void draw_fines(cv::Mat& canvas, const Panel& panel, const std::vector<DrawnFine>& fines,
                FineColour colouring, const ColourScale& speeds);

/// Clogged throats: black lines with a white edge.
void draw_chords(cv::Mat& canvas, const Panel& panel,
                 const std::vector<std::array<Vec3, 2>>& chords);

/// Scale bar, flow arrow and, where colours stand for fates, what they mean.
void draw_footer(cv::Mat& canvas, const cv::Rect& plot, int y, Real per_pixel, const RunView& view,
                 const RunStyle& style, const std::array<int, 2>& axes);

}  // namespace porefines::report
