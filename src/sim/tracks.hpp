// SPDX-License-Identifier: MPL-2.0
// The tables that a run with particles writes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "config/case.hpp"
#include "io/series.hpp"
#include "sim/dry_state.hpp"
#include "sim/session.hpp"

namespace porefines::sim {

/// Columns of tracks.csv, the same as those of a tracked video.
[[nodiscard]] std::vector<std::string> track_columns(bool forces);

/// One row per particle, sorted by id, on rank 0; "" elsewhere. Collective.
[[nodiscard]] std::string track_rows(const DryRun& run);

/// The same for those that leaves(i) names, with the state `out`. Collective.
[[nodiscard]] std::string out_rows(const DryRun& run,
                                   const std::function<bool(std::size_t)>& leaves);

/// Columns of series.csv and its row of the moment.
[[nodiscard]] std::vector<std::string> series_columns();
[[nodiscard]] std::vector<Real> series_row(const DryRun& run, const Moment& now);

/// A table of its own, or one continued after `time`.
[[nodiscard]] io::SeriesWriter open_table(const std::string& path,
                                          const std::vector<std::string>& names, Real time,
                                          Start start);

/// Is the next sample of this output now? Then it counts as written.
[[nodiscard]] bool falls_due(DryRun& run, config::OutputKind kind);

/// Is there more of this than at the end? Series always, tracks and movies when asked for, pictures
/// and fields when they say how often.
[[nodiscard]] bool is_sampled(const config::Case& the_case, config::OutputKind kind);

/// [s] from sample to sample: what the case says, or a hundredth of the run.
[[nodiscard]] Real sample_interval(const config::Case& the_case, config::OutputKind kind);

}  // namespace porefines::sim
