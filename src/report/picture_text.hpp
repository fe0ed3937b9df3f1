// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include <opencv2/core.hpp>

#include "report/picture_colormap.hpp"

namespace porefines::report {

enum class Anchor { left, centre, right };

/// How a text is drawn. Positions are pixels from the top left corner.
struct TextStyle {
  Real height = 15;  ///< [pixels] of a capital letter
  Rgb colour{40, 42, 46};
  Anchor anchor = Anchor::left;
  bool bold = false;
  bool upwards = false;  ///< turned a quarter to the left; x, y then is the foot of the baseline
};

/// Draws one line of text, its baseline at y.
///
/// ASCII, µ, × and ·; "^" raises the sign and digits behind it ("10^-6 m^2"). Other characters
/// become "?". Strokes are drawn four times too large and averaged.
void draw_text(cv::Mat& canvas, const std::string& text, int x, int y, const TextStyle& style);

/// [pixels] along the baseline.
[[nodiscard]] int text_width(const std::string& text, const TextStyle& style);

/// The style with smaller letters, if need be, for `text` to be no longer than `width` [pixels].
[[nodiscard]] TextStyle fitted(TextStyle style, const std::string& text, int width);

}  // namespace porefines::report
