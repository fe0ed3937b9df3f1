// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <deque>
#include <functional>
#include <string>
#include <unordered_map>
#include <vector>

#include "vision/guide.hpp"
#include "vision/stuck.hpp"
#include "vision/track_table.hpp"

namespace porefines::vision {

/// From pixels to SI.
struct Scale {
  Real pixel_size = 1;  ///< [m]
  Real frame_time = 1;  ///< [s]
  int height = 1;       ///< [pixels] of the frame: y turns upwards
  int first_frame = 0;
  Real diameter = TrackRow::unknown;  ///< [m]
};

/// [s] of a frame counted from the first that was tracked: 19 frames at 10 a second are 1.9 s.
[[nodiscard]] inline Real time_of(const Scale& scale, int frame) {
  return (scale.first_frame + frame) / (1 / scale.frame_time);
}

/// Which tracks there are in the end, and when they rested.
struct Kept {
  std::vector<Index> number;  ///< of every linked track, from 1; 0: dropped
  std::unordered_map<Index, std::vector<Rest>> rests;  ///< by linked track
};

/// Turns linked spots into rows with velocities, frame by frame:
///
///     u = (x_next - x_before) / (t_next - t_before),
///
/// one-sided at the ends of a track. Where a particle was out of sight for some frames and came back, it
/// has rows in between, on the straight line. Rows leave as soon as the
/// next sighting is known or cannot come any more, after `memory` + 1 frames.
class RowMaker {
 public:
  using Sink = std::function<void(int frame, std::vector<TrackRow>& rows)>;

  RowMaker(const Scale& scale, const Kept& kept, int memory, Sink sink)
      : scale_(scale), kept_(kept), memory_(memory), sink_(std::move(sink)) {}
  void add(int frame, const Spots& spots, const std::vector<Index>& ids);
  void finish();

 private:
  struct Waiting {
    int frame;
    std::vector<TrackRow> rows;
    std::vector<Index> ids;       ///< linked tracks of the rows
    std::vector<int> next_frame;  ///< of the next sighting; -1: none yet
    std::vector<TrackRow> next;
    std::vector<int> before_frame;
    std::vector<TrackRow> before;
  };
  void fill_gap(int from, std::size_t at, const TrackRow& to, int frame);
  void release();
  [[nodiscard]] TrackState state_of(Index id, int frame) const;

  Scale scale_;
  const Kept& kept_;
  int memory_;
  Sink sink_;
  std::deque<Waiting> waiting_;
  std::unordered_map<Index, std::pair<int, std::size_t>>
      last_;  ///< frame and row of the last sighting
};

}  // namespace porefines::vision
