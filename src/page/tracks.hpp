// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include "core/types.hpp"

namespace porefines::page {

/// tracks.csv as frames for the player, thinned evenly in time to about `most` positions.
///
/// JSON {"times_in_file", "rows_in_file", "times": [s], "starts": [place of a frame's first row, one
/// past the last], "ids": [], "diameters_m": [] (per particle), "low_m", "high_m" (of x, y, z),
/// "speed_range", and packed per row "particle" (place in ids), "x", "y", "z", "speed" (16-bit over
/// these ranges), "state" (0 mobile, 1 retained, 2 out)}; with forces in the file also "forces":
/// {"time_s", "mean_n", "max_n"} over the particles of each time (at most 1,000 of them).
/// Returns "null" where there is no tracks.csv. Reads the file twice, memory does not grow with it.
/// Test: cli/report.
[[nodiscard]] std::string tracks_json(const std::string& folder, std::size_t most = 80'000);

}  // namespace porefines::page
