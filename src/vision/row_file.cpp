// SPDX-License-Identifier: MPL-2.0
#include "vision/row_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include <opencv2/videoio.hpp>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/progress.hpp"
#include "vision/spool.hpp"

namespace porefines::vision {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// Arrows as long as the way of this time: such that the mean step becomes about twelve pixels.
Real arrow_time(const LinkedVideo& linked, const Scale& scale) {
  constexpr Real wanted = 12;
  const Real usual = std::max(0.5 * linked.range, 1.0);
  return scale.frame_time * std::clamp(wanted / usual, 0.5, 8.0);
}

/// Draws on the frames again, in step with the rows.
class Annotator {
 public:
  Annotator(const TrackRequest& request, const LinkedVideo& linked, const Scale& scale,
            int diameter)
      : video_(request.video), scale_(scale), diameter_(diameter) {
    time_ = arrow_time(linked, scale);
    constexpr int soon = 100;  // a video file is read from its start
    middle_ = std::min(linked.frames / 2, soon);
    folder_ = request.output_dir;
    wanted_ = request.settings.video;
    video_.seek(request.settings.start + (wanted_ ? 0 : middle_));
    if (wanted_) {
      writer_.open(folder_ + "/annotated.avi", cv::VideoWriter::fourcc('M', 'J', 'P', 'G'),
                   1 / scale.frame_time, video_.size(), true);
      if (!writer_.isOpened()) {
        throw RunError("cannot write " + folder_ + "/annotated.avi");
      }
    }
  }

  void add(int frame, std::span<const TrackRow> rows) {
    if (!wanted_ && frame != middle_) {
      return;
    }
    const auto picture = video_.read(1);
    if (picture.empty()) {
      return;
    }
    const cv::Mat drawn = draw_arrows(picture[0], rows, scale_, time_, diameter_);
    if (wanted_) {
      writer_.write(drawn);
    }
    if (frame == middle_) {
      write_mat(folder_ + "/arrows.png", drawn, io::make_provenance(1, 0));
    }
  }

 private:
  Video video_;
  Scale scale_;
  int diameter_;
  Real time_ = 1;
  int middle_ = 0;
  bool wanted_ = true;
  std::string folder_;
  cv::VideoWriter writer_;
};

}  // namespace

void write_rows(const TrackRequest& request, const LinkedVideo& linked, const Scale& scale,
                int diameter, TrackResults& results) {
  AtomicFile table(request.output_dir + "/tracks.csv");
  table.write(track_header());
  Annotator annotator(request, linked, scale, diameter);
  Progress progress("write");
  std::string text;
  RowMaker maker(scale, linked.kept, request.settings.memory,
                 [&](int frame, std::vector<TrackRow>& rows) {
                   text.clear();
                   for (const TrackRow& row : rows) {
                     text += track_line(row);
                   }
                   table.write(text);
                   results.add(frame, rows);
                   annotator.add(frame, rows);
                   progress.update((frame + 1.0) / linked.frames);
                 });
  SpotReader reader(linked.spots);
  std::unique_ptr<std::FILE, CloseFile> ids_file(std::fopen(linked.ids.c_str(), "rb"));
  Spots spots;
  std::vector<Index> ids;
  for (int f = 0; f < linked.frames && reader.next(spots); ++f) {
    ids.resize(spots.size());
    if (!ids_file ||
        std::fread(ids.data(), sizeof(Index), ids.size(), ids_file.get()) != ids.size()) {
      throw RunError("cannot read " + linked.ids);
    }
    maker.add(f, spots, ids);
  }
  maker.finish();
  table.commit();
}

}  // namespace porefines::vision
