// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <optional>
#include <string>

#include "vision/align.hpp"

namespace porefines::vision {

struct CompareRequest {
  std::string run_dir;     ///< tracks.csv, and fields or grains.png for the alignment
  std::string tracks_dir;  ///< of `porefines track`
  std::string output_dir = "compare";
  std::optional<Alignment> alignment;  ///< given; absent: found from the grains of both, or none
};

/// How well a run and a video agree.
struct RunAgreement {
  Alignment alignment;
  Real speed_correlation = 0;  ///< of the mean speed against time
  Real speed_nrms = 0;         ///< root mean square difference / mean of the run
  Real speed_largest = 0;      ///< largest difference / mean of the run
  Real sigma_x_nrms = 0;
  Real sigma_x_largest = 0;
  Real sigma_y_nrms = 0;
  Real sigma_y_largest = 0;
  Real histogram_overlap = 0;   ///< sum of the smaller of the two shares
  Real streamline_overlap = 0;  ///< cosine of the two maps of positions
  Real retained_matched = 0;    ///< share of the retained places of the run that the video has too
  Real agreement = 0;           ///< mean of 1 - nrms of speed and sigmas, and of both overlaps
};

/// Overlays a run and a video, as the thesis's figures 17 to 19: streamlines.png, mean_speed.png,
/// sigma.png, speed_histogram.png and agreement.json. Of both sides only what lies in the picture
/// of the video counts, and there farther from its border than half a particle: what is nearer is half seen.
/// @throws InputError  a table is missing, or nothing overlaps
/// Tests: vision/compare, vision/closed_loop.
[[nodiscard]] RunAgreement compare(const CompareRequest& request);

}  // namespace porefines::vision
