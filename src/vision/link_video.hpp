// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

#include "vision/detect_video.hpp"
#include "vision/emit.hpp"
#include "vision/link.hpp"

namespace porefines::vision {

/// Which spots belong together.
struct LinkedVideo {
  std::string spots;
  std::string ids;  ///< path of the file of tracks, one number per spot
  int frames = 0;
  Kept kept;
  std::vector<Rest> rests;  ///< of kept tracks
  std::vector<int> first;   ///< first and last frame of every linked track
  std::vector<int> last;
  Index tracks = 0;  ///< kept
  Index stuck_tracks = 0;
  Real range = 0;  ///< [pixels a frame]
  Motion motion;
};

/// Finds the mean flow and the way that particles move from parts of the video, then links all of it.
[[nodiscard]] LinkedVideo link_video(const std::string& folder, const DetectedVideo& detected,
                                     cv::Size size, const TrackSettings& settings, Real frame_rate);

/// The largest step of a guide with three deviations [pixels].
[[nodiscard]] Real reach_of(const Guide& guide);

/// The range when nobody says it [pixels]: one and a half times the reach of the mean flow, between half
/// a spacing and two and a half.
[[nodiscard]] Real estimated_range(std::span<const Spots> frames, const std::vector<bool>& breaks,
                                   cv::Size size);

}  // namespace porefines::vision
