// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include "vision/microscope.hpp"
#include "vision/tracers.hpp"

namespace porefines::vision {

struct SynthesisRequest {
  std::string source;  ///< tracks.csv, or the folder of a run with tracks or fields
  std::string output_dir = "video";
  Microscope microscope;    ///< width or height 0: as large as what is shown
  Real pixel_size = 0;      ///< [m]
  Real diameter = 0;        ///< [m] of particles whose size the tracks do not say
  Real depth_of_field = 0;  ///< [m]
  TracerSpec tracers;       ///< for a run without tracks
  std::string grains;  ///< picture with dark grains, as large as the frame; empty: those of the run
  bool avi = false;    ///< video.avi instead of a folder of images
};

/// Renders tracks into a video and keeps the truth beside it:
/// frames/ or video.avi, grains.png, truth/tracks.csv, and track.toml, ready for `porefines track`.
/// Every time of the tracks is a frame. @return number of frames
/// @throws InputError  no tracks and no fields, no pixel size
/// Test: vision/closed_loop.
int synthesize(const SynthesisRequest& request);

}  // namespace porefines::vision
