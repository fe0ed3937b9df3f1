// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "config/tree.hpp"
#include "vision/estimate.hpp"
#include "vision/link.hpp"
#include "vision/still.hpp"

namespace porefines::vision {

enum class BackgroundKind { automatic, none, median };

/// What TRACK.toml says, in SI; a zero means: not said.
struct TrackSettings {
  Real frame_rate = 0;  ///< [1/s]
  Real pixel_size = 0;  ///< [m]
  int start = 0;
  int stop = -1;                          ///< last frame; -1: the end
  std::array<int, 4> region{0, 0, 0, 0};  ///< left, top, width, height [pixels]

  DetectWishes detect;  ///< its lengths are filled from the next two
  Real diameter = 0;    ///< [m]
  Real separation = 0;  ///< [m]
  GrainKind grains = GrainKind::automatic;
  std::string mask;
  BackgroundKind background = BackgroundKind::automatic;

  LinkMethod method = LinkMethod::assignment;
  Real max_speed = 0;             ///< [m/s]
  int memory = 3;                 ///< [frames]
  int min_length = 3;             ///< [frames]
  std::array<int, 2> flow{0, 0};  ///< direction, y upwards
  Real least_slope = 1;
  std::string velocity_field;  ///< folder of a run
  Real stuck_time = 0;         ///< [s]

  bool video = true;  ///< write annotated.avi
};

/// One key of the track file: all there is to know about it.
struct TrackKey {
  std::string path;  ///< "detect.diameter"
  std::string type;
  std::string absent;  ///< what leaving it out means
  std::string doc;
  std::function<void(TrackSettings&, const config::Node&)> read;
};
[[nodiscard]] const std::vector<TrackKey>& track_keys();

/// Reads a track file; relative paths in it start at its folder.
/// @param path       may be empty: then only the overrides count
/// @param overrides  "link.max_speed=50 um/s", as for a case
/// @throws InputError  `track.toml:4: [detect] diametr: unknown key; did you mean diameter?`
/// Test: vision/settings.
[[nodiscard]] TrackSettings load_track(const std::string& path,
                                       const std::vector<std::string>& overrides = {});

/// The table of keys of docs/track.md.
[[nodiscard]] std::string track_reference();

}  // namespace porefines::vision
