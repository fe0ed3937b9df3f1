// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include "config/case.hpp"

namespace porefines::page {

/// The grains of a case for the page: numbers, size histograms, and what the player draws.
struct GeometryData {
  std::string metrics = {};     ///< JSON: metrics.json of inspect; empty: none
  std::string histograms = {};  ///< JSON: {"pores": {"edges": [m], "share": []}, "throats": {...}}
  std::string scene = {};       ///< JSON: {"size": [m], "outlines": ... } or {"field": ...}
  std::string missing = {};     ///< why there is none
};

/// Builds the sample anew from the files that the case names and measures it as inspect does.
///
/// Flat samples become outlines simplified to half a pixel; volumes the share of grain on at most
/// 64^3 points. Images beyond 30 million voxels are not measured (`missing` says so), nor are those
/// whose files are gone. Not collective: one rank. Test: cli/report.
[[nodiscard]] GeometryData describe_geometry(const config::Case& the_case);

}  // namespace porefines::page
