// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "vision/detect.hpp"

namespace porefines::vision {

/// The centre of the light of the particle whose brightest pixel is `start`: a disc of the particle's
/// diameter moves by whole pixels until the centroid of what it holds is within 0.6 pixels of its
/// middle. Mass and peak are those of the disc.
/// @param signal  background gone, nothing below the threshold [float]
/// Source: Crocker & Grier, J. Colloid Interface Sci. 179 (1996) 298. Test: vision/detect.
[[nodiscard]] Spot centroid(const cv::Mat& signal, const cv::Point& start, int diameter);

}  // namespace porefines::vision
