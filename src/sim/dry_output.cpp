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

namespace {

/// A movie cannot go on in an old file: a resumed run begins another, named after its first frame.
std::string movie_name(const Sink& sink, Index frames_before) {
  return frames_before == 0 ? sink.folder + "/movie.mp4"
                            : fmt::format("{}/movie_{:05}.mp4", sink.folder, frames_before);
}

void add_frame(const DryRun& run, Sink& sink, const report::Picture& picture, Index frames_before) {
  if (!sink.movie) {
    const config::Output* output = config::find_output(run.the_case, config::OutputKind::movie);
    sink.movie.emplace(movie_name(sink, frames_before), picture.width, picture.height,
                       output->frame_rate, sink.provenance, run.the_case.run.title);
  }
  sink.movie->add({picture.width, picture.height, 3, picture.rgb});
}

/// Still pictures and frames of the movie; one painting serves both.
void show_due(DryRun& run, Sink& sink, const std::function<report::Picture()>& paint) {
  using enum config::OutputKind;
  const Index stills = run.state.written_of(pictures);
  const Index frames = run.state.written_of(movie);
  const bool still = falls_due(run, pictures);
  const bool frame = falls_due(run, movie);
  if (!still && !frame) {
    return;
  }
  const report::Picture picture = paint();
  if (still) {
    write_moment(fmt::format("{}/particles_{:05}.png", sink.folder, stills), run, picture,
                 sink.provenance);
  }
  if (frame) {
    on_root(run.comm, [&] { add_frame(run, sink, picture, frames); });
  }
}

}  // namespace

void write_due(DryRun& run, Sink& sink, const std::string& left) {
  write_due(run, sink, left,
            {[&] { return series_row(run, look(run)); }, [&] { return paint_dry(run); }});
}

void write_due(DryRun& run, Sink& sink, const std::string& left, const View& view) {
  std::string rows = left;
  if (falls_due(run, config::OutputKind::tracks)) {
    rows += track_rows(run);
  }
  std::vector<Real> series;
  if (falls_due(run, config::OutputKind::summary)) {
    series = view.row();
  }
  on_root(run.comm, [&] {
    if (sink.tracks && !rows.empty()) {
      sink.tracks->append_lines(rows);
    }
    if (!series.empty()) {
      sink.series->append(series);
    }
  });
  show_due(run, sink, view.picture);
}

void finish_movie(const DryRun& run, Sink& sink) {
  on_root(run.comm, [&] {
    if (sink.movie) {
      sink.movie->finish();
      sink.movie.reset();
    }
  });
}

}  // namespace porefines::sim
