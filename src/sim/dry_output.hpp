// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/movie.hpp"
#include "io/provenance.hpp"
#include "io/series.hpp"
#include "report/picture.hpp"
#include "sim/dry_state.hpp"
#include "sim/session.hpp"
#include "sim/tracks.hpp"

namespace porefines::sim {

/// Where results go on the way; the tables are open on rank 0 alone.
struct Sink {
  std::string folder;
  io::Provenance provenance;
  std::optional<io::SeriesWriter> series = {};
  std::optional<io::SeriesWriter> tracks = {};
  std::optional<io::MovieWriter> movie = {};  ///< from its first frame on
};

/// Starts the tables, series.csv with these columns, or continues them after run.state.time: what an earlier run wrote later goes.
/// Collective.
[[nodiscard]] Sink open_sink(const std::string& folder, const DryRun& run,
                             const io::Provenance& provenance, Start start,
                             const std::vector<std::string>& columns = series_columns());

/// What a run shows of the moment; both are asked for on every rank, when they are due.
struct View {
  std::function<std::vector<Real>()> row;    ///< of series.csv
  std::function<report::Picture()> picture;  ///< counts on rank 0
};

/// Writes the samples that are due: series, tracks, pictures, movie. Collective.
/// @param left  rows of those that left, for tracks.csv
void write_due(DryRun& run, Sink& sink, const std::string& left, const View& view);
/// As a dry run shows itself.
void write_due(DryRun& run, Sink& sink, const std::string& left);

/// Completes the movie. Collective.
void finish_movie(const DryRun& run, Sink& sink);

}  // namespace porefines::sim
