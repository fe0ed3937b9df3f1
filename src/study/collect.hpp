// SPDX-License-Identifier: MPL-2.0
// What is read from the output folder of a member.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analysis/bands.hpp"
#include "analysis/survival.hpp"
#include "core/types.hpp"

namespace porefines::study {

/// A curve that every run with fines has; members are drawn together as bands.
struct CurveKind {
  const char* name;  ///< of its chart, and in bands.csv
  const char* title;
  const char* table;  ///< series.csv, or the last profile of retention.csv
  const char* x;      ///< columns
  const char* y;
  const char* x_name;
  const char* x_unit;
  const char* y_name;
  const char* y_unit;
};

inline constexpr std::array<CurveKind, 6> curve_kinds{
    {{"k_volumes", "Permeability", "series.csv", "pore_volumes", "permeability_ratio",
      "pore volumes", "", "k/k0", ""},
     {"k_time", "Permeability", "series.csv", "time_s", "permeability_ratio", "time", "s", "k/k0",
      ""},
     {"breakthrough", "Breakthrough", "series.csv", "pore_volumes", "concentration_ratio",
      "pore volumes", "", "C/C0", ""},
     {"spread_x", "Spread of the fines along x", "series.csv", "time_s", "sigma_x_m", "time", "s",
      "sigma x", "m"},
     {"retained", "Retained fines along the flow", "retention.csv", "x_m", "retained_fraction", "x",
      "m", "share of pore volume", ""},
     {"porosity", "Porosity along the flow", "retention.csv", "x_m", "porosity", "x", "m",
      "porosity", ""}}};

/// A run that is done.
struct Result {
  std::vector<Real> readings;   ///< NaN where the run has none
  bool clogs = false;           ///< it writes a clogging log
  analysis::Lifetime time;      ///< [s] to the first clog
  analysis::Lifetime volumes;   ///< pore volumes
  analysis::Lifetime escapees;  ///< fines that left before
  std::array<analysis::Sampled, curve_kinds.size()> curves;
  Real wall_time = 0;  ///< [s]
};

/// Readings: KEY of summary.json, series.COLUMN.last (first, min, max, mean), clogging.COLUMN (of the first
/// clog).
[[nodiscard]] std::string reading_problem(const std::string& reading);  ///< "" when it is one
inline constexpr const char* reading_help =
    "a key of summary.json, series.COLUMN.last (or first, min, max, mean), or clogging.COLUMN";
[[nodiscard]] std::vector<std::string> default_readings();

/// Empty unless summary.json says that the run is done.
[[nodiscard]] std::optional<Result> collect(const std::string& folder,
                                            const std::vector<std::string>& readings);

/// Whether summary.json there says so.
[[nodiscard]] bool is_done(const std::string& folder);

/// Share of the run's time that its series.csv has come to; 0 without one.
[[nodiscard]] Real progress_of(const std::string& folder, Real end_time);

}  // namespace porefines::study
