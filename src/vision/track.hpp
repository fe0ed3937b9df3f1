// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include "vision/settings.hpp"

namespace porefines::vision {

struct TrackRequest {
  std::string video;
  std::string output_dir = "tracks";
  int threads = 1;
  bool resume = false;  ///< go on behind the frames that an interrupted call had detected
  bool debug = false;   ///< write the stages of the first frame, stages.png
  TrackSettings settings;
};

/// From a video to tracks, statistics and pictures in the output folder:
/// tracks.csv, series.csv, events.csv, summary.json, msd, histogram, speed map, streamlines, arrows, video.
///
/// Frames are detected on all threads into a file, then linked and written frame by frame, so memory
/// does not grow with the video and the result is the same for any number of threads and whether or not it
/// was interrupted.
/// @return  0; 2 when the video could not be read to its end or held no particles; 128 + n for signal n.
///          What was tracked is written in every case.
/// @throws InputError, RunError
[[nodiscard]] int track(const TrackRequest& request);

}  // namespace porefines::vision
