// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

namespace porefines::page {

/// Everything that the page shows of a run, as JSON; web/src reads it.
///
/// {"kind": "flow"|"coupled"|"dry"|"inertial", "folder", "summary", "case", "log", "warnings", "geometry",
/// "histograms", "scene", "walls", "maps", "pictures", "series", "retention", "clogging", "throats", "tracks",
/// "agreement", "made"}; what the run does not have is null or an empty list, never left out.
/// @throws InputError  the folder holds no run: no case.toml or no summary.json
/// Test: cli/report.
[[nodiscard]] std::string run_island(const std::string& folder);

}  // namespace porefines::page
