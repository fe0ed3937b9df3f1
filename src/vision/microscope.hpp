// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <span>

#include <opencv2/core.hpp>

#include "core/types.hpp"

namespace porefines::vision {

/// A synthetic microscope with its camera. Lengths in pixels, intensities in grey levels 0..255.
struct Microscope {
  int width = 640;
  int height = 424;
  bool dark = false;     ///< particles darker than the water
  Real background = 90;  ///< grey level of the water
  Real contrast = 90;    ///< a particle in focus, at its centre, above (below) the water
  Real snr = 10;         ///< contrast / standard deviation of the noise at that centre; 0: no noise
  Real shot = 0.3;       ///< share of that variance that grows with the light
  Real point_spread = 1.2;   ///< standard deviation of the image of a point in focus
  Real depth_of_field = 20;  ///< distance from focus at which that width is sqrt(2) times larger
  Real uneven = 0.15;        ///< light falls off by this share towards one corner
  Real grain = 0.6;          ///< grey level of grains / of the water
  Real grain_edge = 1.5;     ///< standard deviation of their blurred outline
  unsigned long long seed = 1;
};

/// A particle as the camera sees it: centres of pixels have whole coordinates, y points down.
struct Seen {
  Real x = 0;
  Real y = 0;
  Real out_of_focus = 0;  ///< distance from the focal plane
  Real diameter = 4;
};

/// The light without particles and noise [float grey levels].
/// @param grains  nonzero where a grain is; empty: none
[[nodiscard]] cv::Mat still_light(const Microscope& microscope, const cv::Mat& grains);

/// One 8-bit frame. A particle is a Gaussian of variance
///
///     s^2 = point_spread^2 (1 + (out_of_focus / depth_of_field)^2) + diameter^2 / 16
///
/// (a disc and a point-spread function have these second moments) whose total light does not depend
/// on the focus. Noise is normal; of its variance (contrast / snr)^2 at the centre of a particle in
/// focus the share `shot` is proportional to the light, the rest is the camera's.
/// The same frame number gives the same noise. Tests: unit/vision_microscope.
[[nodiscard]] cv::Mat expose(const Microscope& microscope, const cv::Mat& light,
                             std::span<const Seen> particles, int frame);

}  // namespace porefines::vision
