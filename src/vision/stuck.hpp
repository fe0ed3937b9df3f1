// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <unordered_map>
#include <vector>

#include "vision/guide.hpp"

namespace porefines::vision {

/// A track that stayed where it was from frame `first` to `last`.
struct Rest {
  Index id = 0;
  int first = 0;
  int last = 0;
  Real x = 0;  ///< [pixels] mean place
  Real y = 0;
};

struct StuckSettings {
  int frames = 40;        ///< at rest for so long: stuck
  Real tolerance = 0.75;  ///< [pixels] from the mean place
  Real noise = 0.3;       ///< [pixels] of a centre along one axis
};

/// Finds particles that do not move, frame by frame; keeps only live tracks and the rests found.
///
/// A track rests until three sightings in a row lie beyond the tolerance of its mean place, and only if
/// the means of the first and the second half of that time differ by less than four deviations of such
/// means (and a quarter of a pixel): what creeps does not rest.
/// Test: vision/stuck.
class RestFinder {
 public:
  explicit RestFinder(const StuckSettings& settings) : settings_(settings) {}
  void add(int frame, const Spots& spots, const std::vector<Index>& ids);
  /// Ends what rests still; sorted by first frame, then id. @param last_frame of the video
  [[nodiscard]] std::vector<Rest> finish();

 private:
  struct Anchored {
    int first = 0;
    int last = 0;
    int count = 0;
    int astray = 0;  ///< sightings in a row beyond the tolerance
    Real x = 0;      ///< sums
    Real y = 0;
    std::vector<cv::Point2f> places;  ///< every `stride`-th, for the halves
    int stride = 1;
  };
  void close(Index id, const Anchored& a);

  StuckSettings settings_;
  std::unordered_map<Index, Anchored> live_;
  std::vector<Rest> rests_;
};

}  // namespace porefines::vision
