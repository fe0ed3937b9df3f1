// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/json.hpp"
#include "io/fields.hpp"
#include "sim/coupled_pictures.hpp"
#include "sim/dry_output.hpp"

namespace porefines::sim {

/// Where a coupled run writes on the way.
struct CoupledSink {
  Sink tables;
  std::optional<io::FieldWriter> fields = {};
  Readings readings = {};
};

/// Starts the tables, or continues them after the time of a resumed run. Collective.
[[nodiscard]] CoupledSink open_coupled_sink(const std::string& folder, const CoupledRun& run,
                                            const geom::Sample& sample,
                                            std::span<const float> solid,
                                            const io::Provenance& provenance, Start start);

/// Writes what is due: a row of series.csv and the readings, tracks, fields, pictures. Collective.
/// @param left   rows of those that left, for tracks.csv
/// @param solid  share of each cell that is grain
void write_coupled(CoupledRun& run, CoupledSink& sink, const std::string& left,
                   const RunCanvas& canvas, std::span<const float> solid);

/// The last moment, where no sample fell on it: its fields, and its pictures. Completes the movie.
/// Collective.
void write_end(CoupledRun& run, CoupledSink& sink, const RunCanvas& canvas,
               const geom::Sample& sample, std::span<const float> solid);

/// Columns of series.csv.
[[nodiscard]] std::vector<std::string> coupled_columns();

/// What the particles add to summary.json. Collective.
void add_coupled(Json& json, const CoupledRun& run);

}  // namespace porefines::sim
