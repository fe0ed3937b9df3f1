// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/breakthrough.hpp"
#include "analysis/clogging.hpp"
#include "analysis/retention.hpp"
#include "analysis/throat_pressure.hpp"
#include "io/series.hpp"

namespace porefines::analysis {

/// What stays the same during a run.
struct ReadingSetup {
  geom::PoreNetwork network;
  ProfileBins bins;
  std::vector<Real> pore_volumes;  ///< [m^3] per bin, as pore_volumes_along gives them
  Real area = 0;                   ///< [m^2] cross-section, grains included
  RestRules rest;
  BlockRules blocks;
  Real c0 = 0;  ///< volume fraction asked for; 0: measured
};

/// What a restart needs.
struct ReadingState {
  CloggingState clogging;
  BreakthroughMeter breakthrough;
};

[[nodiscard]] std::vector<Real> pack(const ReadingState& state);
/// @throws RunError  when the numbers are not those of a state
[[nodiscard]] ReadingState unpack_readings(std::span<const Real> numbers);

/// The tables in the output folder: clogging.csv, retention.csv, throats_pressure.csv.
/// Use it on rank 0.
class ReadingTables {
 public:
  /// Writes throats.csv and pores.csv and begins the tables.
  /// @param resume  [s] of the checkpoint that the run goes on from: keeps rows up to then
  ReadingTables(const std::string& folder, const geom::PoreNetwork& network,
                std::optional<Real> resume = {});

  io::SeriesWriter clogging;
  io::SeriesWriter retention;
  io::SeriesWriter pressure;
};

/// Numbers for series.csv: concentrations, shares of fates, clogged throats.
struct Reading {
  Breakthrough breakthrough;
  FateCounts counts;
  Index clogged_throats = 0;
  std::vector<ClogEvent> events;
};

[[nodiscard]] std::vector<std::string> reading_columns();
[[nodiscard]] std::vector<Real> reading_row(const Reading& reading);

/// Takes one sample on rank 0: moves the state on and, where tables are given, appends to them.
///
/// @param pressures  read_throats of the same moment; empty: none are written
/// Cost O(particles + throats + bins). Test: unit/readings (files, restart).
[[nodiscard]] Reading take_reading(ReadingState& state, const ReadingSetup& setup,
                                   const RunSample& sample, const Throughput& throughput,
                                   const std::vector<ThroatPressure>& pressures,
                                   ReadingTables* tables);

}  // namespace porefines::analysis
