// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/json.hpp"
#include "io/fields.hpp"
#include "io/provenance.hpp"
#include "io/series.hpp"
#include "sim/inertial_state.hpp"
#include "sim/session.hpp"

namespace porefines::sim {

/// Where a run with inertia writes on the way; tables are open on rank 0 alone.
struct InertialSink {
  std::string folder;
  io::Provenance provenance;
  std::optional<io::SeriesWriter> series = {};
  std::optional<io::FieldWriter> fields = {};
};

/// Starts series.csv and fields.xdmf, or continues them after the time of a resumed run. Collective.
[[nodiscard]] InertialSink open_inertial_sink(const std::string& folder, const InertialRun& run,
                                              const io::Provenance& provenance, Start start);

/// Writes what is due: a row of series.csv, fields. Collective.
void write_inertial(InertialRun& run, InertialSink& sink, std::span<const float> solid);

/// Columns of series.csv: time, flow, energy, then each body's force and coefficients, then probes.
[[nodiscard]] std::vector<std::string> inertial_columns(const InertialRun& run);

/// What inertia adds to summary.json: forces, Strouhal number, wake. Collective.
void add_inertial(Json& json, InertialRun& run, const std::string& folder);

}  // namespace porefines::sim
