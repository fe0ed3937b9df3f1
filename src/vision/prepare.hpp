// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

#include "core/log.hpp"
#include "vision/settings.hpp"
#include "vision/video.hpp"

namespace porefines::vision {

/// All that detection needs, decided once for the whole video.
struct Prepared {
  DetectSettings detect;
  Still still;
  cv::Mat median;               ///< empty: too few frames
  int stuck = 0;                ///< particles in the median
  std::vector<cv::Mat> sample;  ///< the frames that it was estimated from
};

/// Frames spread evenly over the first 2000 of a folder, 400 of a video file, from `start` on, at most `most`.
[[nodiscard]] std::vector<cv::Mat> sample_frames(const std::string& path, int start, int stop,
                                                 int most);

/// Background, grains and every number of the detection.
[[nodiscard]] Prepared prepare(const std::string& video, const TrackSettings& settings);

/// What was decided, for the log and for the fingerprint of the spots.
[[nodiscard]] std::string describe(const Prepared& prepared, Real pixel_size);

}  // namespace porefines::vision
