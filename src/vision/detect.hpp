// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "core/types.hpp"

namespace porefines::vision {

/// A particle in a frame [pixels, grey levels]. Centres of pixels have whole coordinates, y is down.
struct Spot {
  Real x = 0;
  Real y = 0;
  Real mass = 0;  ///< sum of the light above the background
  Real peak = 0;
};

/// How a centre is found below the pixel.
enum class Centre {
  contour,   ///< centroid of the thresholded outline, as the thesis does
  centroid,  ///< weighted by light, in a disc of the particle's diameter (Crocker & Grier 1996)
  gaussian,  ///< of the Gaussians that fit it and its neighbours best, see fit.hpp
};

/// Every number is decided; see estimate.hpp for where they come from.
struct DetectSettings {
  bool dark = false;     ///< particles are darker than the water
  int diameter = 9;      ///< of the image of a particle with its halo, odd
  Real separation = 10;  ///< closer than this, only the one with more light is kept
  Real least_mass = 0;   ///< what has less light is noise
  Real noise = 1;        ///< standard deviation of the blur that comes first
  Real threshold = 1;    ///< [grey levels] above the background that count
  Centre centre = Centre::gaussian;
  bool whole_levels = false;  ///< local background rounded down to whole grey levels
};

/// What does not move.
struct Still {
  cv::Mat light;   ///< [float] the frame without moving particles; empty: not known
  cv::Mat grains;  ///< nonzero: a grain, or outside of the region of interest; empty: none
};

/// Pictures of the stages.
struct Stages {
  cv::Mat grey;
  cv::Mat blurred;
  cv::Mat flattened;  ///< background gone, grains masked, particles bright
  cv::Mat binary;     ///< above the threshold, after erosion and dilation
};

/// Finds particles: grey -> Gaussian blur -> background and grains removed -> threshold -> erosion
/// and dilation -> one candidate per local maximum of an outline -> centre below the pixel.
///
/// The background is the mean over a square as wide as a particle and its surroundings, after the
/// still light is gone. Touching particles have a maximum each. Centroids nearer to the border than
/// half a diameter are not looked for; Gaussians are fitted up to it.
/// @param frame  one channel; 8 or 16 bits
/// Sorted by y, then x: the result depends on nothing but the frame.
/// Tests: vision/detect, vision/real_video.
[[nodiscard]] std::vector<Spot> detect(const cv::Mat& frame, const Still& still,
                                       const DetectSettings& settings, Stages* stages = nullptr);

/// The light of moving particles, bright: still light gone, inverted where they are dark [float].
[[nodiscard]] cv::Mat particle_light(const cv::Mat& frame, const Still& still,
                                     const DetectSettings& settings);

/// particle_light() blurred, without its background and without grains [float].
[[nodiscard]] cv::Mat flatten(const cv::Mat& light, const Still& still,
                              const DetectSettings& settings);

}  // namespace porefines::vision
