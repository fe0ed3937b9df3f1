// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <vector>

#include "vision/detect.hpp"

namespace porefines::vision {

/// Moves the spots to where Gaussians fit the light best, and sets their mass and peak.
///
///     I(x, y) = b + a exp(-((x - x0)^2 + (y - y0)^2) / 2 s^2)
///
/// least squares in x0, y0, a, s and b over the disc of the particle's diameter (Levenberg-Marquardt),
/// with the models of all other particles taken away first; particles that touch are visited several
/// times. For white noise this is the most that a centre can be known: 0.8 / SNR pixels. A fit that
/// leaves the disc keeps the start.
/// @param light  particles bright, still light gone, not blurred [float]
/// @param spots  sorted by y; on entry at the brightest pixels
/// Test: vision/detect.
void fit_gaussians(const cv::Mat& light, std::vector<Spot>& spots, int diameter);

}  // namespace porefines::vision
