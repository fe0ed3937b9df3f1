// SPDX-License-Identifier: MPL-2.0
#include "sim/dry_output.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "sim/dry_checkpoint.hpp"
#include "sim/dry_results.hpp"
#include "sim/tracks.hpp"

namespace porefines::sim {

Sink open_sink(const std::string& folder, const DryRun& run, const io::Provenance& provenance,
               Start start, const std::vector<std::string>& columns) {
  Sink sink{folder, provenance};
  on_root(run.comm, [&] {
    const Real time = run.state.time;
    sink.series.emplace(open_table(folder + "/series.csv", columns, time, start));
    if (const auto* output = config::find_output(run.the_case, config::OutputKind::tracks)) {
      sink.tracks.emplace(
          open_table(folder + "/tracks.csv", track_columns(output->forces), time, start));
    }
  });
  return sink;
}

void write_due(DryRun& run, Sink& sink, const std::string& left) {
  write_due(run, sink, left, [&] { return series_row(run, look(run)); });
}

void write_due(DryRun& run, Sink& sink, const std::string& left,
               const std::function<std::vector<Real>()>& row) {
  std::string rows = left;
  if (is_due(run.the_case, config::OutputKind::tracks, run.state.tracked, run.state.time)) {
    rows += track_rows(run);
    ++run.state.tracked;
  }
  std::vector<Real> series;
  if (is_due(run.the_case, config::OutputKind::summary, run.state.samples, run.state.time)) {
    series = row();
    ++run.state.samples;
  }
  on_root(run.comm, [&] {
    if (sink.tracks && !rows.empty()) {
      sink.tracks->append_lines(rows);
    }
    if (!series.empty()) {
      sink.series->append(series);
    }
  });
  if (is_due(run.the_case, config::OutputKind::pictures, run.state.drawn, run.state.time)) {
    draw_dry(fmt::format("{}/particles_{:05}.png", sink.folder, run.state.drawn), run,
             sink.provenance);
    ++run.state.drawn;
  }
}

void save(const DryRun& run, Sink& sink, Real wall_time, Log& log) {
  save(run, sink, wall_time, log, [&] { write_checkpoint(run, sink.folder, sink.provenance); });
}

void save(const DryRun& run, Sink& sink, Real wall_time, Log& log,
          const std::function<void()>& write) {
  sink.saved = wall_time;
  try {
    write();
    log.info("checkpoint at {:.9g} s, step {}", run.state.time, run.state.steps);
  } catch (const RunError& failure) {
    log.warn("no checkpoint at {:.6g} s: {}", run.state.time, failure.what());
  }
}

}  // namespace porefines::sim
