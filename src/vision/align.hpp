// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <opencv2/core.hpp>

#include "core/types.hpp"

namespace porefines::vision {

/// From places of the video to places of the run [m]:
///
///     x_run = shift + scale R(angle) x_video
struct Alignment {
  Real shift_x = 0;  ///< [m]
  Real shift_y = 0;
  Real angle = 0;  ///< [rad] anticlockwise
  Real scale = 1;
  Real overlap = 0;  ///< of the grain masks so aligned: correlation, 1 is perfect

  [[nodiscard]] cv::Point2d apply(const cv::Point2d& x) const;
};

/// Finds the alignment of two grain masks by their correlation: scales 0.8 to 1.25 and angles within 14
/// degrees in steps, the shift of each by correlation; then all four together by halving steps.
/// @param video, run  nonzero: grain; row 0 at the top; one pixel of `pixel_size` [m] each
/// Test: vision/align.
[[nodiscard]] Alignment align(const cv::Mat& video, const cv::Mat& run, Real pixel_size);

}  // namespace porefines::vision
