// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

namespace porefines::page {

/// Speed and pressure of the last fields of a run on its middle planes, for plots with hover.
///
/// JSON list of {"quantity", "unit", "normal": "z", "axes": ["x","y"], "n": [w, h], "low_m": [x, y],
/// "step_m": [dx, dy], "range": [low, high], "values": packed 16-bit}; grains are none16. Planes with
/// more than `most` cells are thinned evenly. A flat domain has the plane normal to z alone.
/// Returns "[]" where the folder holds no fields. One rank. Test: cli/report.
[[nodiscard]] std::string maps_json(const std::string& folder, std::size_t most = 300'000);

}  // namespace porefines::page
