// SPDX-License-Identifier: MPL-2.0
#include "vision/still.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "core/error.hpp"
#include "vision/video.hpp"

namespace porefines::vision {
namespace {

constexpr Real grain_blur = 2.5;  // [pixels] before thresholding

/// Removes islands of a binary picture (255) smaller than this many pixels.
void drop_islands(cv::Mat& binary, int smallest) {
  cv::Mat labels;
  cv::Mat stats;
  cv::Mat centres;
  const int count = cv::connectedComponentsWithStats(binary, labels, stats, centres, 8);
  std::vector<std::uint8_t> keep(static_cast<std::size_t>(count), 0);
  for (int k = 1; k < count; ++k) {
    keep[static_cast<std::size_t>(k)] = stats.at<int>(k, cv::CC_STAT_AREA) >= smallest ? 255 : 0;
  }
  for (int j = 0; j < binary.rows; ++j) {
    for (int i = 0; i < binary.cols; ++i) {
      binary.at<std::uint8_t>(j, i) = keep[static_cast<std::size_t>(labels.at<int>(j, i))];
    }
  }
}

/// Largest deviation from the median that any frame shows [float].
cv::Mat activity(std::span<const cv::Mat> frames, const cv::Mat& median) {
  cv::Mat most(median.size(), CV_32F, cv::Scalar(0));
  for (const cv::Mat& frame : frames) {
    cv::Mat change = to_float(frame) - median;
    cv::GaussianBlur(change, change, {}, 1);
    most = cv::max(most, cv::abs(change));
  }
  return most;
}

/// Is there a gap between the grey levels of the two sides?
bool two_sides(const cv::Mat& smooth, Real dark, Real bright) {
  const Real middle = 0.5 * (dark + bright);
  const Real tenth = 0.1 * (bright - dark);
  const cv::Mat between = (smooth > middle - tenth) & (smooth < middle + tenth);
  constexpr Real most = 0.1;
  constexpr Real least_contrast = 0.08;
  return cv::countNonZero(between) < most * static_cast<Real>(smooth.total()) &&
         bright - dark > least_contrast * bright;
}

/// The light with that of the pores nearby in place of grains: a pore as narrow as a particle between dark
/// grains looks like a bright one otherwise.
cv::Mat without_grains(const cv::Mat& light, const cv::Mat& grains, Real reach) {
  if (grains.empty()) {
    return light;
  }
  cv::Mat pores;
  cv::Mat(grains == 0).convertTo(pores, CV_32F, 1.0 / 255);
  cv::Mat near;
  cv::Mat weight;
  cv::GaussianBlur(light.mul(pores), near, {}, reach);
  cv::GaussianBlur(pores, weight, {}, reach);
  near /= weight + 1e-6;
  cv::Mat out = light.clone();
  near.copyTo(out, grains);
  return out;
}

}  // namespace

cv::Mat median_light(std::span<const cv::Mat> frames) {
  cv::Mat out(frames[0].size(), CV_32F);
  std::vector<cv::Mat> light;
  for (const cv::Mat& frame : frames) {
    light.push_back(to_float(frame));
  }
  std::vector<float> values(frames.size());
  const auto middle = static_cast<std::ptrdiff_t>(frames.size() / 2);
  for (int j = 0; j < out.rows; ++j) {
    for (int i = 0; i < out.cols; ++i) {
      for (std::size_t f = 0; f < light.size(); ++f) {
        values[f] = light[f].at<float>(j, i);
      }
      std::nth_element(values.begin(), values.begin() + middle, values.end());
      out.at<float>(j, i) = values[static_cast<std::size_t>(middle)];
    }
  }
  return out;
}

cv::Mat find_grains(std::span<const cv::Mat> frames, const cv::Mat& median, GrainKind kind,
                    int smallest) {
  if (kind == GrainKind::none) {
    return {};
  }
  cv::Mat smooth;
  cv::GaussianBlur(median, smooth, {}, grain_blur);
  cv::Mat bytes;
  smooth.convertTo(bytes, CV_8U);
  cv::Mat bright;
  const Real level = cv::threshold(bytes, bright, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU);
  bright = smooth > level + 0.5;
  const cv::Mat dark = ~bright;
  if (cv::countNonZero(bright) == 0 || cv::countNonZero(dark) == 0) {
    return {};
  }
  if (kind == GrainKind::automatic) {
    if (!two_sides(smooth, cv::mean(smooth, dark)[0], cv::mean(smooth, bright)[0])) {
      return {};
    }
    const cv::Mat moving = activity(frames, median);
    kind = cv::mean(moving, dark)[0] < cv::mean(moving, bright)[0] ? GrainKind::dark
                                                                   : GrainKind::bright;
  }
  cv::Mat grains = kind == GrainKind::dark ? dark : bright.clone();
  drop_islands(grains, smallest);
  cv::Mat pores = ~grains;
  drop_islands(pores, smallest);
  grains = ~pores;
  return cv::countNonZero(grains) > 0 ? grains : cv::Mat();
}

cv::Mat without_stuck(const cv::Mat& median, const cv::Mat& grains, const DetectSettings& settings,
                      int* stuck) {
  const int size = settings.diameter + 4;
  const cv::Mat element = cv::getStructuringElement(cv::MORPH_ELLIPSE, {size, size});
  cv::Mat around;
  cv::Mat smooth;
  cv::GaussianBlur(without_grains(median, grains, settings.diameter), smooth, {}, 0.7);
  cv::morphologyEx(smooth, around, settings.dark ? cv::MORPH_CLOSE : cv::MORPH_OPEN, element);
  const cv::Mat hat = settings.dark ? cv::Mat(around - smooth) : cv::Mat(smooth - around);
  DetectSettings s = settings;
  s.dark = false;
  s.centre = Centre::centroid;
  s.whole_levels = false;
  cv::Mat out = median.clone();
  int found = 0;
  for (const Spot& spot : detect(hat, {{}, grains}, s)) {
    const cv::Point at(static_cast<int>(std::lround(spot.x)),
                       static_cast<int>(std::lround(spot.y)));
    cv::Mat disc(hat.size(), CV_8U, cv::Scalar(0));
    cv::Mat ring = disc.clone();
    cv::circle(disc, at, s.diameter / 2 + 1, 255, cv::FILLED);
    cv::circle(ring, at, s.diameter / 2 + 3, 255, 2);
    constexpr Real alone = 0.3;
    if (cv::mean(hat, ring)[0] < alone * hat.at<float>(at)) {
      if (!grains.empty()) {
        disc.setTo(0, grains);
      }
      around.copyTo(out, disc);
      ++found;
    }
  }
  if (stuck != nullptr) {
    *stuck = found;
  }
  return out;
}

cv::Mat read_mask(const std::string& path, cv::Size frame, GrainKind kind) {
  const cv::Mat picture = read_grey(path);
  if (picture.empty()) {
    throw InputError(path + ": cannot be read as an image");
  }
  if (picture.size() != frame) {
    throw InputError(fmt::format("{}: a mask of {} x {} pixels for frames of {} x {}", path,
                                 picture.cols, picture.rows, frame.width, frame.height));
  }
  constexpr Real middle = 127.5;
  const cv::Mat light = to_float(picture);
  return kind == GrainKind::bright ? cv::Mat(light > middle) : cv::Mat(light < middle);
}

}  // namespace porefines::vision
