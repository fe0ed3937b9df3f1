// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/readings.hpp"
#include "sim/coupled_state.hpp"
#include "sim/session.hpp"

namespace porefines::sim {

/// What is read off fines and pressures at every sample, and the tables it goes to. What a restart
/// needs of it is in CoupledState::readings.
struct Readings {
  analysis::ReadingSetup setup;
  analysis::PressureProbes probes;
  std::optional<analysis::ReadingTables> tables;  ///< rank 0
  std::vector<std::uint64_t> ids;  ///< rank 0: of the last sample, in the order of its fates
};

/// Finds pores and throats, begins or continues clogging.csv, retention.csv, throats_pressure.csv,
/// and writes throats.csv and pores.csv. Collective.
/// @param solid  share of each cell that is grain
[[nodiscard]] Readings open_readings(const std::string& folder, const CoupledRun& run,
                                     const geom::Sample& sample, std::span<const float> solid,
                                     Start start);

/// Takes a sample: clogging log, retention, pressures at throats. Collective.
/// @return what series.csv says of it, as analysis::reading_columns; counts on rank 0
[[nodiscard]] std::vector<Real> take_readings(CoupledRun& run, Readings& readings,
                                              const MomentFields& fields);

}  // namespace porefines::sim
