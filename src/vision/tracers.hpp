// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <vector>

#include "vision/flow_field.hpp"
#include "vision/track_table.hpp"

namespace porefines::vision {

struct TracerSpec {
  int count = 200;  ///< in the box at any time, about
  int frames = 100;
  Real frame_time = 1;  ///< [s]
  bool middle = true;   ///< all on the middle plane; otherwise anywhere in the depth
  Real clearance = 0;   ///< [m] from grains at the start: the radius of the particles
  Real apart = 0;       ///< [m] between any two at the start, where there is room
  int stuck = 0;        ///< further ones that never move
  unsigned long long seed = 1;
};

/// Points that the flow of a run carries, frame by frame, as rows of a table of tracks. They start
/// anywhere in the pores where the flow has a hundredth of its speed at the inlet; what leaves is followed by a new one at the inlet, where the flow is strong in
/// proportion, so that the concentration stays even. Velocities are those of the field.
/// Test: vision/tracers.
[[nodiscard]] std::vector<std::vector<TrackRow>> make_tracers(const FlowField& field,
                                                              const TracerSpec& spec);

}  // namespace porefines::vision
