// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cmath>

#include <opencv2/core.hpp>

#include "report/picture.hpp"

namespace porefines::report {

/// From a value in SI to a place on the colour bar.
struct ColourScale {
  Real low = 0;
  Real high = 1;
  bool logarithmic = false;
  Colormap colormap = Colormap::speed;

  /// 0 at `low`, 1 at `high`; not clamped; -infinity where there is no logarithm.
  [[nodiscard]] Real position(Real value) const {
    return logarithmic ? (std::log(value > 0 ? value : 0) - std::log(low)) / std::log(high / low)
                       : (value - low) / (high - low);
  }
};

/// Paints a slice into a rectangle of the canvas.
///
/// Enlarged: bilinear between the fluid cells around a pixel, grains where they are the majority,
/// their outline sharp to a pixel; or one colour per cell when not `smooth`. Reduced: the mean
/// over the fluid cells behind a pixel, shaded by how much of them is grain.
void paint_slice(cv::Mat& canvas, const cv::Rect& where, const Slice& slice,
                 const ColourScale& scale, bool smooth);

}  // namespace porefines::report
