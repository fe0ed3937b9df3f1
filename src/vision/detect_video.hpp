// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include "core/log.hpp"
#include "vision/prepare.hpp"
#include "vision/track.hpp"

namespace porefines::vision {

/// How far the detection came.
struct DetectedVideo {
  std::string spots;  ///< path of the file of spots, see spool.hpp
  int frames = 0;
  int signal = 0;       ///< the signal that ended it; 0: none
  std::string problem;  ///< why the video ended early; empty: it did not
};

/// Detects all frames of the request on its threads into spots.bin of the output folder. Goes on where
/// an earlier call with the same numbers stopped, when asked to.
[[nodiscard]] DetectedVideo detect_video(Video& video, const Prepared& prepared,
                                         const TrackRequest& request, Log& log);

}  // namespace porefines::vision
