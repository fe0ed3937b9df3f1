// SPDX-License-Identifier: MPL-2.0
#include "vision/estimate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "core/error.hpp"
#include "vision/video.hpp"

namespace porefines::vision {
namespace {

constexpr int widest = 21;  // [pixels] of the windows before the diameter is known
// Chosen on the listed centres of image_sequence; bulk_water then has its 370 a frame as well.
constexpr Real faint_levels =
    2.88;  // [grey levels] mean over the disc of a particle in faint frames

/// Value below which this share of the numbers lies.
Real quantile(std::vector<float>& values, Real share) {
  if (values.empty()) {
    return 0;
  }
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<Real>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

std::vector<float> outside_grains(const cv::Mat& picture, const Still& still) {
  std::vector<float> values;
  for (int j = 0; j < picture.rows; ++j) {
    for (int i = 0; i < picture.cols; ++i) {
      if (still.grains.empty() || still.grains.at<std::uint8_t>(j, i) == 0) {
        values.push_back(picture.at<float>(j, i));
      }
    }
  }
  return values;
}

bool is_dark(std::span<const cv::Mat> frames, const Still& still) {
  DetectSettings s;
  s.diameter = widest;
  Real cubes = 0;
  for (const cv::Mat& frame : frames) {
    for (const float v :
         outside_grains(flatten(particle_light(frame, still, s), still, s), still)) {
      cubes += static_cast<Real>(v) * v * v;
    }
  }
  return cubes < 0;
}

/// Image of bright particles against the distance from the centre: medians, so that neighbours do not
/// count.
std::vector<Real> profile(std::span<const cv::Mat> frames, const Still& still, bool dark) {
  constexpr std::size_t brightest = 60;
  DetectSettings s;
  s.dark = dark;
  s.diameter = widest;
  s.centre = Centre::centroid;
  std::vector<std::vector<float>> rings(widest);
  for (const cv::Mat& frame : frames) {
    const cv::Mat signal = flatten(particle_light(frame, still, s), still, s);
    auto spots = detect(frame, still, s);
    std::sort(spots.begin(), spots.end(),
              [](const Spot& a, const Spot& b) { return a.peak > b.peak; });
    spots.resize(std::min(spots.size(), brightest));
    for (const Spot& spot : spots) {
      const auto x = static_cast<int>(std::lround(spot.x));
      const auto y = static_cast<int>(std::lround(spot.y));
      const cv::Rect inside(cv::Point(), signal.size());
      for (int dy = -widest; dy <= widest; ++dy) {
        for (int dx = -widest; dx <= widest; ++dx) {
          const auto r = static_cast<std::size_t>(std::lround(std::hypot(dx, dy)));
          if (r < rings.size() && inside.contains({x + dx, y + dy})) {
            rings[r].push_back(signal.at<float>(y + dy, x + dx) / static_cast<float>(spot.peak));
          }
        }
      }
    }
  }
  std::vector<Real> out;
  for (auto& ring : rings) {
    out.push_back(quantile(ring, 0.5));
  }
  return out;
}

int odd_diameter(Real wanted) {
  constexpr int smallest = 3;
  return std::max(smallest, 2 * static_cast<int>(std::lround((wanted - 1) / 2)) + 1);
}

int diameter_of(const std::vector<Real>& profile) {
  const Real edge = 0.16 * profile[0];
  for (std::size_t r = 1; r < profile.size(); ++r) {
    if (profile[r] < edge) {
      const Real part = (profile[r - 1] - edge) / (profile[r - 1] - profile[r]);
      return odd_diameter(2 * (static_cast<Real>(r) - 1 + part) + 1);
    }
  }
  return widest;
}

/// Standard deviation of the pixels below the median, which particles do not reach.
Real noise_of(const cv::Mat& frame, const Still& still, const DetectSettings& s) {
  auto values = outside_grains(flatten(particle_light(frame, still, s), still, s), still);
  constexpr Real one_sigma_below = 0.1587;
  return quantile(values, 0.5) - quantile(values, one_sigma_below);
}

Real least_mass(const cv::Mat& frame, const Still& still, const DetectSettings& s) {
  constexpr Real sigmas = 6;
  constexpr Real mad = 1.4826;
  cv::Mat signal = flatten(particle_light(frame, still, s), still, s);
  const int radius = s.diameter / 2;
  cv::Mat disc(s.diameter, s.diameter, CV_32F, cv::Scalar(0));
  for (int j = -radius; j <= radius; ++j) {
    for (int i = -radius; i <= radius; ++i) {
      disc.at<float>(j + radius, i + radius) = i * i + j * j <= radius * radius ? 1 : 0;
    }
  }
  cv::Mat light;
  cv::filter2D(signal, light, -1, disc);
  auto values = outside_grains(light, still);
  const auto median = static_cast<float>(quantile(values, 0.5));
  for (float& value : values) {
    value = std::abs(value - median);
  }
  return median + sigmas * mad * quantile(values, 0.5);
}

/// Pixels whose middle is within the radius.
Real disc_area(int diameter) {
  const int radius = diameter / 2;
  int count = 0;
  for (int j = -radius; j <= radius; ++j) {
    for (int i = -radius; i <= radius; ++i) {
      count += i * i + j * j <= radius * radius ? 1 : 0;
    }
  }
  return count;
}

/// Peak of the particles that are brighter than three quarters of them.
Real brightness(const cv::Mat& frame, const Still& still, const DetectSettings& s) {
  std::vector<float> peaks;
  for (const Spot& spot : detect(frame, still, s)) {
    peaks.push_back(static_cast<float>(spot.peak));
  }
  return quantile(peaks, 0.75);
}

template <typename Measure>
Real mean_over(std::span<const cv::Mat> frames, const Measure& measure_one) {
  Real sum = 0;
  for (const cv::Mat& frame : frames) {
    sum += measure_one(frame);
  }
  return sum / static_cast<Real>(frames.size());
}

void decide_levels(std::span<const cv::Mat> frames, const Still& still, const DetectWishes& wishes,
                   DetectSettings& s) {
  const auto threshold = [&](const cv::Mat& f) { return 1.5 * noise_of(f, still, s); };
  const auto mass = [&](const cv::Mat& f) { return least_mass(f, still, s); };
  s.threshold = wishes.threshold ? *wishes.threshold
                : s.whole_levels ? 1
                                 : std::max(1.0, mean_over(frames, threshold));
  s.least_mass = wishes.least_mass ? *wishes.least_mass
                 : s.whole_levels  ? faint_levels * disc_area(s.diameter)
                                   : mean_over(frames, mass);
}

}  // namespace

DetectSettings estimate(std::span<const cv::Mat> frames, const Still& still,
                        const DetectWishes& wishes) {
  if (frames.empty()) {
    throw InputError("there are no frames to estimate the detection from");
  }
  DetectSettings s;
  s.noise = wishes.noise.value_or(s.noise);
  s.dark = wishes.dark ? *wishes.dark : is_dark(frames, still);
  s.diameter = wishes.diameter ? odd_diameter(*wishes.diameter)
                               : diameter_of(profile(frames, still, s.dark));
  s.separation = wishes.separation.value_or(0.6 * s.diameter);
  decide_levels(frames, still, wishes, s);
  constexpr Real faint = 32;  // [grey levels]
  s.whole_levels = wishes.whole_levels.value_or(frames[0].depth() == CV_8U &&
                                                brightness(frames[0], still, s) < faint);
  s.centre = wishes.centre.value_or(s.whole_levels ? Centre::centroid : Centre::gaussian);
  if (s.whole_levels) {
    s.separation = wishes.separation.value_or(s.diameter + 1);
    decide_levels(frames, still, wishes, s);
  }
  return s;
}

}  // namespace porefines::vision
