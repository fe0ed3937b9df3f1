// SPDX-License-Identifier: MPL-2.0
#include "vision/detect.hpp"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "vision/centroid.hpp"
#include "vision/fit.hpp"
#include "vision/pairs.hpp"
#include "vision/video.hpp"

namespace porefines::vision {
namespace {

/// Mean over a square, rounded down to whole grey levels after each axis: what 8-bit arithmetic does.
void whole_box(const cv::Mat& light, cv::Mat& mean, int width) {
  const auto down = [](cv::Mat& m) {
    for (int j = 0; j < m.rows; ++j) {
      auto* const line = m.ptr<float>(j);
      std::transform(line, line + m.cols, line, [](float v) { return std::floor(v + 1e-4F); });
    }
  };
  cv::Mat rows;
  cv::boxFilter(light, rows, -1, {1, width}, {-1, -1}, true, cv::BORDER_REPLICATE);
  down(rows);
  cv::boxFilter(rows, mean, -1, {width, 1}, {-1, -1}, true, cv::BORDER_REPLICATE);
  down(mean);
}

/// Highest value of the square around each pixel that reaches `reach` to every side.
cv::Mat highest_around(const cv::Mat& signal, int reach) {
  cv::Mat out;
  cv::dilate(signal, out, cv::Mat::ones(2 * reach + 1, 2 * reach + 1, CV_8U));
  return out;
}

/// Erosion, then dilation: what is thinner than three pixels goes.
cv::Mat cleaned(const cv::Mat& signal, Real threshold) {
  cv::Mat binary = signal > threshold;
  cv::morphologyEx(binary, binary, cv::MORPH_OPEN, cv::Mat::ones(3, 3, CV_8U));
  return binary;
}

std::vector<cv::Point> candidates(const cv::Mat& signal, const cv::Mat& binary,
                                  const DetectSettings& s) {
  // No two maxima of a square window are nearer than its half width plus one; the final distances are
  // left to the centres.
  const int reach = std::max(1, static_cast<int>(s.separation / 2));
  const int margin = s.centre == Centre::centroid ? s.diameter / 2 : 1;
  const cv::Mat highest = highest_around(signal, reach);
  std::vector<cv::Point> out;
  for (int j = margin; j < signal.rows - margin; ++j) {
    const auto* const value = signal.ptr<float>(j);
    const auto* const high = highest.ptr<float>(j);
    const auto* const inside = binary.ptr<std::uint8_t>(j);
    for (int i = margin; i < signal.cols - margin; ++i) {
      if (inside[i] != 0 && value[i] >= high[i]) {
        out.emplace_back(i, j);
      }
    }
  }
  return out;
}

/// Of every two that are too close the one with more light stays.
std::vector<Spot> thinned(std::vector<Spot> spots, Real separation) {
  std::sort(spots.begin(), spots.end(),
            [](const Spot& a, const Spot& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
  std::vector<char> drop(spots.size(), 0);
  for (std::size_t i = 0; i < spots.size(); ++i) {
    for (std::size_t j = i + 1; j < spots.size() && spots[j].y - spots[i].y < separation; ++j) {
      if (std::hypot(spots[i].x - spots[j].x, spots[i].y - spots[j].y) < separation) {
        drop[spots[i].mass < spots[j].mass ? i : j] = 1;
      }
    }
  }
  std::vector<Spot> kept;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    if (drop[i] == 0) {
      kept.push_back(spots[i]);
    }
  }
  return kept;
}

/// Centroids of the outlines, one per particle that touches no other.
std::vector<Spot> outlines(const cv::Mat& signal, const cv::Mat& binary) {
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(binary.clone(), contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  std::vector<Spot> spots;
  for (const auto& contour : contours) {
    const cv::Rect box = cv::boundingRect(contour);
    cv::Mat filled(box.size(), CV_8U, cv::Scalar(0));
    cv::drawContours(filled, std::vector<std::vector<cv::Point>>{contour}, 0, 255, cv::FILLED,
                     cv::LINE_8, {}, 0, -box.tl());
    const cv::Moments sums = cv::moments(filled, true);
    const cv::Mat light = signal(box);
    Spot spot{box.x + sums.m10 / sums.m00, box.y + sums.m01 / sums.m00, 0, 0};
    spot.mass = cv::mean(light, filled)[0] * sums.m00;
    cv::minMaxLoc(light, nullptr, &spot.peak, nullptr, nullptr, filled);
    spots.push_back(spot);
  }
  return spots;
}

}  // namespace

cv::Mat particle_light(const cv::Mat& frame, const Still& still, const DetectSettings& s) {
  cv::Mat light = to_float(frame);
  if (!still.light.empty()) {
    light -= still.light;
  }
  if (s.dark) {
    light = (still.light.empty() ? 255.0 : 0.0) - light;
  }
  return light;
}

cv::Mat flatten(const cv::Mat& light, const Still& still, const DetectSettings& s) {
  cv::Mat signal;
  cv::Mat mean;
  cv::GaussianBlur(light, signal, {}, s.noise, s.noise, cv::BORDER_REPLICATE);
  if (s.whole_levels) {
    whole_box(light, mean, s.diameter);
  } else {
    cv::boxFilter(light, mean, -1, {s.diameter, s.diameter}, {-1, -1}, true, cv::BORDER_REPLICATE);
  }
  signal -= mean;
  if (!still.grains.empty()) {
    signal.setTo(0, still.grains);
  }
  return signal;
}

std::vector<Spot> detect(const cv::Mat& frame, const Still& still, const DetectSettings& s,
                         Stages* stages) {
  const cv::Mat light = particle_light(frame, still, s);
  cv::Mat signal = flatten(light, still, s);
  const cv::Mat binary = cleaned(signal, s.threshold);
  if (stages != nullptr) {
    stages->grey = frame;
    cv::GaussianBlur(to_float(frame), stages->blurred, {}, s.noise);
    stages->flattened = signal.clone();
    stages->binary = binary;
  }
  signal.setTo(0, signal < s.threshold);
  std::vector<Spot> spots;
  if (s.centre == Centre::contour) {
    spots = outlines(signal, binary);
  } else {
    for (const cv::Point& start : candidates(signal, binary, s)) {
      Spot spot = centroid(signal, start, s.diameter);
      if (s.centre == Centre::gaussian) {
        spot.x = start.x;  // a neighbour may have drawn the centroid away
        spot.y = start.y;
      }
      spots.push_back(spot);
    }
  }
  std::erase_if(spots, [&](const Spot& spot) { return spot.mass < s.least_mass; });
  if (s.centre != Centre::gaussian) {
    return thinned(std::move(spots), s.separation);
  }
  constexpr Real usual = 0.61;  // [diameters] who asks for more wants no pairs
  const bool pairs = s.separation <= usual * s.diameter;
  const Real separation = pairs ? 0.75 * s.separation : s.separation;
  spots = thinned(std::move(spots), separation);
  fit_gaussians(light, spots, s.diameter);
  spots = thinned(std::move(spots), separation);
  if (pairs) {
    split_pairs(light, spots, s.diameter);
  }
  return spots;
}

}  // namespace porefines::vision
