// SPDX-License-Identifier: MPL-2.0
#include "report/picture_text.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace porefines::report {
namespace {

constexpr int oversampling = 4;
constexpr int font = cv::FONT_HERSHEY_SIMPLEX;
constexpr Real capital = 21;  ///< [pixels] height of a capital of this font at scale 1

/// A piece of text in one size; the signs that the font lacks stand alone.
struct Run {
  std::string text;
  bool raised = false;
  char sign = 0;  ///< 'u': micro, 'x': times, '.': dot
};

void add_letter(std::vector<Run>& runs, char letter, bool raised) {
  if (runs.empty() || runs.back().sign != 0 || runs.back().raised != raised) {
    runs.push_back({"", raised, 0});
  }
  runs.back().text += letter;
}

void add_sign(std::vector<Run>& runs, const std::string& letter) {
  const char sign = letter == "µ" ? 'u' : letter == "×" ? 'x' : letter == "·" ? '.' : 0;
  if (sign != 0) {
    runs.push_back({"u", false, sign});
  } else {
    add_letter(runs, '?', false);
  }
}

bool can_be_raised(char letter) {
  return letter == '-' || (letter >= '0' && letter <= '9');
}

std::vector<Run> split(const std::string& text) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte == '^') {
      for (; i + 1 < text.size() && can_be_raised(text[i + 1]); ++i) {
        add_letter(runs, text[i + 1], true);
      }
    } else if (byte < 128) {
      add_letter(runs, text[i], false);
    } else if (byte >= 0xC0) {  // the first byte of a longer character
      add_sign(runs, text.substr(i, 2));
    }
  }
  return runs;
}

struct Pen {
  Real scale;
  int thickness;
};

Pen pen_for(const Run& run, const TextStyle& style) {
  const Real height = oversampling * style.height * (run.raised ? 0.7 : 1.0);
  return {height / capital,
          std::max(1, static_cast<int>(std::lround(height * (style.bold ? 0.145 : 0.105))))};
}

/// Oversampled advance of a run.
int advance(const Run& run, const TextStyle& style) {
  const Pen pen = pen_for(run, style);
  int baseline = 0;
  return cv::getTextSize(run.text, font, pen.scale, 1, &baseline).width;
}

void draw_run(cv::Mat& ink, const Run& run, cv::Point at, const TextStyle& style) {
  const Pen pen = pen_for(run, style);
  const Real height = oversampling * style.height;
  const auto point = [&](Real x, Real y) {
    return cv::Point(at.x + static_cast<int>(std::lround(x)),
                     at.y - static_cast<int>(std::lround(y)));
  };
  const int width = advance(run, style);
  if (run.sign == 'x') {
    const Real r = 0.25 * height;
    cv::line(ink, point(0.5 * width - r, 0.15 * height), point(0.5 * width + r, 0.65 * height), 255,
             pen.thickness, cv::LINE_AA);
    cv::line(ink, point(0.5 * width - r, 0.65 * height), point(0.5 * width + r, 0.15 * height), 255,
             pen.thickness, cv::LINE_AA);
    return;
  }
  if (run.sign == '.') {
    cv::circle(ink, point(0.5 * width, 0.42 * height), pen.thickness, 255, cv::FILLED, cv::LINE_AA);
    return;
  }
  cv::putText(ink, run.text, point(0, run.raised ? 0.5 * height : 0), font, pen.scale, 255,
              pen.thickness, cv::LINE_AA);
  if (run.sign == 'u') {  // the left stem of u goes on below the line
    const Real stem = 4 * pen.scale;
    cv::line(ink, point(stem, 0.4 * height), point(stem, -0.32 * height), 255, pen.thickness,
             cv::LINE_AA);
  }
}

void blend(cv::Mat& canvas, const cv::Mat& ink, int left, int top, const Rgb& colour) {
  const cv::Rect wanted(left, top, ink.cols, ink.rows);
  const cv::Rect inside = wanted & cv::Rect(0, 0, canvas.cols, canvas.rows);
  for (int y = inside.y; y < inside.y + inside.height; ++y) {
    for (int x = inside.x; x < inside.x + inside.width; ++x) {
      const int cover = ink.at<std::uint8_t>(y - top, x - left);
      auto& pixel = canvas.at<cv::Vec3b>(y, x);
      for (int c = 0; c < 3; ++c) {
        pixel[c] = static_cast<std::uint8_t>((pixel[c] * (255 - cover) + colour[c] * cover) / 255);
      }
    }
  }
}

}  // namespace

int text_width(const std::string& text, const TextStyle& style) {
  int width = 0;
  for (const Run& run : split(text)) {
    width += advance(run, style);
  }
  return width / oversampling;
}

TextStyle fitted(TextStyle style, const std::string& text, int width) {
  style.height *= std::min(1.0, static_cast<Real>(width) / std::max(text_width(text, style), 1));
  return style;
}

void draw_text(cv::Mat& canvas, const std::string& text, int x, int y, const TextStyle& style) {
  const int width = text_width(text, style);
  const int above = static_cast<int>(std::ceil(1.6 * style.height));
  const int below = static_cast<int>(std::ceil(0.6 * style.height));
  const int margin = above;
  cv::Mat ink(oversampling * (above + below), oversampling * (width + 2 * margin), CV_8UC1,
              cv::Scalar(0));
  cv::Point at(oversampling * margin, oversampling * above);
  for (const Run& run : split(text)) {
    draw_run(ink, run, at, style);
    at.x += advance(run, style);
  }
  cv::Mat small;
  cv::resize(ink, small, cv::Size(), 1.0 / oversampling, 1.0 / oversampling, cv::INTER_AREA);
  const int shift = style.anchor == Anchor::left     ? 0
                    : style.anchor == Anchor::centre ? width / 2
                                                     : width;
  if (style.upwards) {
    cv::rotate(small, small, cv::ROTATE_90_COUNTERCLOCKWISE);
    blend(canvas, small, x - above, y - (width + margin) + shift, style.colour);
  } else {
    blend(canvas, small, x - margin - shift, y - above, style.colour);
  }
}

}  // namespace porefines::report
