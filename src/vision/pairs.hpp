// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <vector>

#include "vision/detect.hpp"

namespace porefines::vision {

/// Tells two particles apart that lie so near that their light has one maximum.
///
/// A spot with 1.6 times the usual (median) light is fitted again by two Gaussians of the usual width,
///
///     I = b + a1 exp(-|r - r1|^2 / 2 s^2) + a2 exp(-|r - r2|^2 / 2 s^2),
///
/// (Levenberg-Marquardt, started on the long axis of its light). The two replace it when they halve the
/// sum of squares, both have 0.4 of the usual height and they are a width apart: a single large
/// particle is round and stays one.
/// @param light  as for fit_gaussians()
/// @param spots  as they come from there, sorted by y; on return as well
/// Test: vision/detect (tells_apart_what_has_one_maximum).
void split_pairs(const cv::Mat& light, std::vector<Spot>& spots, int diameter);

}  // namespace porefines::vision
