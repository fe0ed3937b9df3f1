// SPDX-License-Identifier: MPL-2.0
#include "vision/centroid.hpp"

#include <algorithm>
#include <cmath>

namespace porefines::vision {
namespace {

constexpr int most_moves = 10;
constexpr Real move_at = 0.6;

/// Sums over a disc; pixels beyond the frame hold nothing.
struct Disc {
  Real mass = 0;
  Real x = 0;  ///< centroid from the middle
  Real y = 0;
};

Disc sum_disc(const cv::Mat& signal, const cv::Point& middle, int radius) {
  Disc out;
  for (int dy = -radius; dy <= radius; ++dy) {
    const int j = middle.y + dy;
    if (j < 0 || j >= signal.rows) {
      continue;
    }
    const auto* const line = signal.ptr<float>(j);
    const auto half = static_cast<int>(std::sqrt(static_cast<Real>(radius * radius - dy * dy)));
    const int last = std::min(middle.x + half, signal.cols - 1);
    for (int i = std::max(middle.x - half, 0); i <= last; ++i) {
      const Real value = line[i];
      out.mass += value;
      out.x += value * (i - middle.x);
      out.y += value * dy;
    }
  }
  out.x = out.mass > 0 ? out.x / out.mass : 0;
  out.y = out.mass > 0 ? out.y / out.mass : 0;
  return out;
}

int step(Real offset) {
  return offset > move_at ? 1 : offset < -move_at ? -1 : 0;
}

}  // namespace

Spot centroid(const cv::Mat& signal, const cv::Point& start, int diameter) {
  cv::Point middle = start;
  const int radius = diameter / 2;
  Disc disc = sum_disc(signal, middle, radius);
  for (int move = 1; move < most_moves && (step(disc.x) != 0 || step(disc.y) != 0); ++move) {
    middle.x = std::clamp(middle.x + step(disc.x), radius, signal.cols - 1 - radius);
    middle.y = std::clamp(middle.y + step(disc.y), radius, signal.rows - 1 - radius);
    disc = sum_disc(signal, middle, radius);
  }
  return {middle.x + disc.x, middle.y + disc.y, disc.mass, signal.at<float>(start)};
}

}  // namespace porefines::vision
