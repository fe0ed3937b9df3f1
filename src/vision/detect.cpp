// SPDX-License-Identifier: MPL-2.0
#include "vision/detect.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

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

/// Mean over a square of odd width, the border repeated: columns summed line by line, then along the line.
/// cv::boxFilter sums floats one after the other in double precision and takes five times as long.
void box_mean(const cv::Mat& light, cv::Mat& mean, int width) {
  const int reach = width / 2;
  cv::Mat wide;
  cv::copyMakeBorder(light, wide, reach, reach, reach, reach, cv::BORDER_REPLICATE);
  mean.create(light.size(), CV_32F);
  std::vector<float> columns(static_cast<std::size_t>(wide.cols), 0);
  const auto add = [&](int j, float sign) {
    const auto* const line = wide.ptr<float>(j);
    for (int i = 0; i < wide.cols; ++i) {
      columns[static_cast<std::size_t>(i)] += sign * line[i];
    }
  };
  for (int j = 0; j < width - 1; ++j) {
    add(j, 1);
  }
  const float share = 1 / static_cast<float>(width * width);
  for (int j = 0; j < mean.rows; ++j) {
    add(j + width - 1, 1);
    auto* const out = mean.ptr<float>(j);
    std::fill(out, out + mean.cols, 0.0F);
    for (int k = 0; k < width; ++k) {
      const float* const from = columns.data() + k;
      for (int i = 0; i < mean.cols; ++i) {
        out[i] += from[i];
      }
    }
    for (int i = 0; i < mean.cols; ++i) {
      out[i] *= share;
    }
    add(j, -1);
  }
}

/// First column from `i` on that is not zero, a multiple of eight at a time.
int next_set(const std::uint8_t* line, int i, int end) {
  while (i < end && line[i] == 0) {
    std::uint64_t eight = 0;
    if (i + 8 <= end) {
      std::memcpy(&eight, line + i, sizeof eight);
    }
    i += i + 8 <= end && eight == 0 ? 8 : 1;
  }
  return i;
}

/// Is nothing in the square around a pixel, which reaches `reach` to every side, higher?
bool is_highest(const cv::Mat& signal, int i, int j, int reach) {
  const float value = signal.ptr<float>(j)[i];
  const int left = std::max(i - reach, 0);
  const int right = std::min(i + reach, signal.cols - 1);
  for (int y = std::max(j - reach, 0); y <= std::min(j + reach, signal.rows - 1); ++y) {
    const auto* const line = signal.ptr<float>(y);
    if (std::any_of(line + left, line + right + 1, [=](float other) { return other > value; })) {
      return false;
    }
  }
  return true;
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
  std::vector<cv::Point> out;
  for (int j = margin; j < signal.rows - margin; ++j) {
    const auto* const value = signal.ptr<float>(j);
    const auto* const inside = binary.ptr<std::uint8_t>(j);
    const int end = signal.cols - margin;
    for (int i = next_set(inside, margin, end); i < end; i = next_set(inside, i + 1, end)) {
      const bool rising = value[i] < value[i - 1] || value[i] < value[i + 1];  // nearly all are
      if (!rising && is_highest(signal, i, j, reach)) {
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
      const Real dx = spots[i].x - spots[j].x;
      const Real dy = spots[i].y - spots[j].y;
      if (dx * dx + dy * dy < separation * separation) {
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
    box_mean(light, mean, s.diameter);
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
  cv::threshold(signal, signal, s.threshold, 0, cv::THRESH_TOZERO);
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
