// SPDX-License-Identifier: MPL-2.0
#include "vision/align.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <opencv2/imgproc.hpp>

namespace porefines::vision {
namespace {

/// shift [pixels], angle, scale about the middle of the picture, y down.
struct Warp {
  Real x = 0;
  Real y = 0;
  Real angle = 0;
  Real scale = 1;
};

cv::Mat matrix_of(const Warp& w, cv::Size size) {
  const Real c = w.scale * std::cos(w.angle);
  const Real s = w.scale * std::sin(w.angle);
  const Real mx = 0.5 * (size.width - 1);
  const Real my = 0.5 * (size.height - 1);
  // y points down: an anticlockwise turn is [c s; -s c].
  return (cv::Mat_<double>(2, 3) << c, s, mx + w.x - c * mx - s * my, -s, c,
          my + w.y + s * mx - c * my);
}

cv::Mat warped(const cv::Mat& picture, const Warp& w) {
  cv::Mat out;
  cv::warpAffine(picture, out, matrix_of(w, picture.size()), picture.size(), cv::INTER_LINEAR,
                 cv::BORDER_CONSTANT, cv::Scalar(0));
  return out;
}

/// Correlation where both pictures are, as long as that is a good part of them.
Real score(const cv::Mat& video, const cv::Mat& inside, const cv::Mat& run,
           const cv::Mat& run_inside, const Warp& w) {
  const cv::Mat there = warped(inside, w);
  const cv::Mat both = (there > 0.99) & run_inside;
  constexpr Real least = 0.2;
  if (cv::countNonZero(both) < least * cv::countNonZero(inside > 0.5)) {
    return -1;
  }
  const cv::Mat a = warped(video, w);
  cv::Scalar mean_a;
  cv::Scalar mean_b;
  cv::Scalar dev_a;
  cv::Scalar dev_b;
  cv::meanStdDev(a, mean_a, dev_a, both);
  cv::meanStdDev(run, mean_b, dev_b, both);
  const cv::Mat product = (a - mean_a[0]).mul(run - mean_b[0]);
  const Real deviation = dev_a[0] * dev_b[0];
  return deviation > 0 ? cv::mean(product, both)[0] / deviation : -1;
}

/// On a canvas that holds either picture, blurred; `inside` marks the picture.
cv::Mat on_canvas(const cv::Mat& mask, cv::Size canvas, Real shrink, Real blur, cv::Mat& inside) {
  cv::Mat small;
  cv::Mat grain = mask > 0;
  cv::resize(grain, small, {}, shrink, shrink, cv::INTER_AREA);
  small.convertTo(small, CV_32F, 1.0 / 255);
  cv::GaussianBlur(small, small, {}, blur);
  cv::Mat out(canvas, CV_32F, cv::Scalar(0));
  inside = cv::Mat(canvas, CV_32F, cv::Scalar(0));
  const cv::Rect where(0, canvas.height - small.rows, small.cols, small.rows);  // lower left
  small.copyTo(out(where));
  inside(where).setTo(1);
  return out;
}

constexpr int coarse = 4;  // the first search looks at every fourth pixel

/// The shift of the highest correlation [pixels of the full picture].
cv::Point2d best_shift(const cv::Mat& video, const cv::Mat& padded_run) {
  cv::Mat correlation;
  cv::matchTemplate(padded_run, video, correlation, cv::TM_CCORR);
  cv::Point top;
  cv::minMaxLoc(correlation, nullptr, nullptr, nullptr, &top);
  const cv::Point shift = coarse * (top - cv::Point(video.cols / 2, video.rows / 2));
  return {static_cast<Real>(shift.x), static_cast<Real>(shift.y)};
}

Warp search(const cv::Mat& video, const cv::Mat& inside, const cv::Mat& run,
            const cv::Mat& run_inside) {
  constexpr Real step = 2 * std::numbers::pi / 180;
  Warp best;
  Real most = score(video, inside, run, run_inside, best);
  // Without their means, so that the empty part of the canvas has no edge.
  const cv::Mat seen = (video - cv::mean(video, inside > 0.5)[0]).mul(inside);
  cv::Mat there;
  run_inside.convertTo(there, CV_32F, 1.0 / 255);
  const cv::Mat known = (run - cv::mean(run, run_inside)[0]).mul(there);
  cv::Mat small_seen;
  cv::Mat padded;
  cv::resize(seen, small_seen, {}, 1.0 / coarse, 1.0 / coarse, cv::INTER_AREA);
  cv::resize(known, padded, small_seen.size(), 0, 0, cv::INTER_AREA);
  cv::copyMakeBorder(padded, padded, small_seen.rows / 2, small_seen.rows / 2, small_seen.cols / 2,
                     small_seen.cols / 2, cv::BORDER_CONSTANT, cv::Scalar(0));
  for (const Real scale : {0.8, 0.84, 0.88, 0.92, 0.96, 1.0, 1.04, 1.08, 1.13, 1.19, 1.25}) {
    for (int turn = -7; turn <= 7; ++turn) {
      Warp w{0, 0, turn * step, scale};
      const cv::Point2d shift = best_shift(warped(small_seen, w), padded);
      w.x = shift.x;
      w.y = shift.y;
      const Real s = score(video, inside, run, run_inside, w);
      if (s > most) {
        most = s;
        best = w;
      }
    }
  }
  return best;
}

/// Pattern search: a step that helps is taken, steps that do not are halved.
Warp polished(const cv::Mat& video, const cv::Mat& inside, const cv::Mat& run,
              const cv::Mat& run_inside, Warp w, Real& most) {
  std::array<Real, 4> steps{4, 4, 0.03, 0.03};
  most = score(video, inside, run, run_inside, w);
  constexpr int rounds = 60;
  for (int round = 0; round < rounds && steps[0] > 0.01; ++round) {
    bool helped = false;
    for (std::size_t k = 0; k < 4; ++k) {
      for (const Real sign : {1.0, -1.0}) {
        Warp next = w;
        (k == 0 ? next.x : k == 1 ? next.y : k == 2 ? next.angle : next.scale) += sign * steps[k];
        const Real s = score(video, inside, run, run_inside, next);
        if (s > most) {
          most = s;
          w = next;
          helped = true;
        }
      }
    }
    if (!helped) {
      std::for_each(steps.begin(), steps.end(), [](Real& step) { step *= 0.5; });
    }
  }
  return w;
}

}  // namespace

cv::Point2d Alignment::apply(const cv::Point2d& x) const {
  const Real c = scale * std::cos(angle);
  const Real s = scale * std::sin(angle);
  return {shift_x + c * x.x - s * x.y, shift_y + s * x.x + c * x.y};
}

Alignment align(const cv::Mat& video, const cv::Mat& run, Real pixel_size) {
  constexpr Real longest = 400;
  const int widest = std::max(video.cols, run.cols);
  const int highest = std::max(video.rows, run.rows);
  const Real shrink = std::min(1.0, longest / std::max(widest, highest));
  const cv::Size canvas(static_cast<int>(std::ceil(widest * shrink)) + 1,
                        static_cast<int>(std::ceil(highest * shrink)) + 1);
  Warp w;
  Real most = -1;
  for (const Real blur : {3.0, 1.0}) {
    cv::Mat inside_video;
    cv::Mat inside_run;
    const cv::Mat a = on_canvas(video, canvas, shrink, blur, inside_video);
    const cv::Mat b = on_canvas(run, canvas, shrink, blur, inside_run);
    const cv::Mat marked = inside_run > 0.5;
    w = blur > 2 ? search(a, inside_video, b, marked) : w;
    w = polished(a, inside_video, b, marked, w, most);
  }
  // From pixels of the canvas (y down) to metres (y up) with the lower left corner as origin.
  Alignment out;
  out.angle = w.angle;
  out.scale = w.scale;
  out.overlap = most;
  const Real unit = pixel_size / shrink;
  const cv::Mat m = matrix_of(w, canvas);
  const Real ox = -0.5;
  const Real oy = canvas.height - 0.5;  // the origin in pixels
  const Real px = m.at<double>(0, 0) * ox + m.at<double>(0, 1) * oy + m.at<double>(0, 2);
  const Real py = m.at<double>(1, 0) * ox + m.at<double>(1, 1) * oy + m.at<double>(1, 2);
  out.shift_x = unit * (px - ox);
  out.shift_y = unit * (oy - py);
  return out;
}

}  // namespace porefines::vision
