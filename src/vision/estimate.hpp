// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <optional>
#include <span>

#include "vision/detect.hpp"

namespace porefines::vision {

/// What the user gave; absent: estimated.
struct DetectWishes {
  std::optional<bool> dark;
  std::optional<Real> diameter;    ///< [pixels]
  std::optional<Real> separation;  ///< [pixels]
  std::optional<Real> least_mass;
  std::optional<Real> threshold;  ///< [grey levels]
  std::optional<Real> noise;      ///< [pixels]
  std::optional<bool> whole_levels;
  std::optional<Centre> centre;
};

/// Decides every number from a few frames, moving particles and all.
///
/// - polarity: the sign of the skewness of the frame without its background;
/// - diameter: twice the radius at which the median image of the brightest particles falls to a sixth
///   of its peak (1.9 standard deviations of a Gaussian), plus the pixel in the middle;
/// - separation: 0.6 diameters;
/// - threshold: 1.5 standard deviations of the noise (from the dark half of the pixels), at least one
///   grey level;
/// - least mass: median + 6 standard deviations (1.4826 MAD) of the light in discs all over the frame;
/// - centre: Gaussian.
///
/// Where the particles of 8-bit frames are fainter than 32 grey levels, haloes and the steps of the
/// grey levels imitate neighbours: then the background is taken in whole levels, only one particle is
/// kept per diameter, a particle has 2.88 levels on the mean over its disc, and centres are centroids.
/// @throws InputError  no frames
/// Test: vision/detect, vision/real_video.
[[nodiscard]] DetectSettings estimate(std::span<const cv::Mat> frames, const Still& still,
                                      const DetectWishes& wishes);

}  // namespace porefines::vision
