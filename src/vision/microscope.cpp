// SPDX-License-Identifier: MPL-2.0
#include "vision/microscope.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "core/random.hpp"

namespace porefines::vision {
namespace {

constexpr Real reach = 4.5;  // standard deviations that are drawn

Real variance_of(const Microscope& m, Real out_of_focus, Real diameter) {
  const Real defocus = out_of_focus / m.depth_of_field;
  return m.point_spread * m.point_spread * (1 + defocus * defocus) + diameter * diameter / 16;
}

void add_particle(const Microscope& m, const Seen& p, cv::Mat& light) {
  const Real variance = variance_of(m, p.out_of_focus, p.diameter);
  const Real peak = (m.dark ? -1 : 1) * m.contrast * variance_of(m, 0, p.diameter) / variance;
  const auto radius = static_cast<int>(std::ceil(reach * std::sqrt(variance)));
  const auto column = static_cast<int>(std::lround(p.x));
  const int low = std::max(column - radius, 0);
  const int high = std::min(column + radius, light.cols - 1);
  std::vector<float> across;
  for (int i = low; i <= high; ++i) {
    across.push_back(static_cast<float>(std::exp(-0.5 * (i - p.x) * (i - p.x) / variance)));
  }
  const auto row = static_cast<int>(std::lround(p.y));
  for (int j = std::max(row - radius, 0); j <= std::min(row + radius, light.rows - 1); ++j) {
    const Real along = peak * std::exp(-0.5 * (j - p.y) * (j - p.y) / variance);
    auto* const line = light.ptr<float>(j);
    for (int i = low; i <= high; ++i) {
      line[i] += static_cast<float>(along) * across[static_cast<std::size_t>(i - low)];
    }
  }
}

/// Normal numbers, four out of two calls of the generator, addressed by frame and row.
void add_noise(const Microscope& m, int frame, cv::Mat& light) {
  const Real variance = m.contrast * m.contrast / (m.snr * m.snr);
  const Real centre = m.background + (m.dark ? -m.contrast : m.contrast);
  const Real camera = variance * (1 - m.shot);
  const Real per_light = variance * m.shot / std::max(centre, 1.0);
  for (int j = 0; j < light.rows; ++j) {
    auto* const line = light.ptr<float>(j);
    for (int i = 0; i < light.cols; i += 4) {
      const auto bits =
          philox({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j),
                  static_cast<std::uint32_t>(frame), 0x6d696372U},
                 {static_cast<std::uint32_t>(m.seed), static_cast<std::uint32_t>(m.seed >> 32)});
      for (int pair = 0; pair < 2; ++pair) {
        const Real u = (bits[static_cast<std::size_t>(2 * pair)] + 0.5) * 0x1p-32;
        const Real turn = bits[static_cast<std::size_t>(2 * pair + 1)] * 0x1p-32;
        const Real radius = std::sqrt(-2 * std::log(u));
        const Real angle = 2 * std::numbers::pi * turn;
        for (int k = 0; k < 2 && i + 2 * pair + k < light.cols; ++k) {
          float& value = line[i + 2 * pair + k];
          const Real normal = radius * (k == 0 ? std::cos(angle) : std::sin(angle));
          const Real sigma = std::sqrt(camera + per_light * std::max<Real>(value, 0));
          value += static_cast<float>(normal * sigma);
        }
      }
    }
  }
}

}  // namespace

cv::Mat still_light(const Microscope& m, const cv::Mat& grains) {
  cv::Mat light(m.height, m.width, CV_32F);
  for (int j = 0; j < m.height; ++j) {
    for (int i = 0; i < m.width; ++i) {
      const Real corner = 0.5 * (static_cast<Real>(i) / m.width + static_cast<Real>(j) / m.height);
      light.at<float>(j, i) = static_cast<float>(m.background * (1 - m.uneven * corner));
    }
  }
  if (!grains.empty()) {
    cv::Mat factor(light.size(), CV_32F, cv::Scalar(1));
    factor.setTo(m.grain, grains);
    cv::GaussianBlur(factor, factor, {}, m.grain_edge);
    light = light.mul(factor);
  }
  return light;
}

cv::Mat expose(const Microscope& microscope, const cv::Mat& light, std::span<const Seen> particles,
               int frame) {
  cv::Mat picture = light.clone();
  for (const Seen& particle : particles) {
    add_particle(microscope, particle, picture);
  }
  if (microscope.snr > 0) {
    add_noise(microscope, frame, picture);
  }
  cv::Mat bytes;
  picture.convertTo(bytes, CV_8U);
  return bytes;
}

}  // namespace porefines::vision
