// SPDX-License-Identifier: MPL-2.0
#include "vision/synthesize.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "vision/draw_tracks.hpp"
#include "vision/still.hpp"

namespace porefines::vision {
namespace {

/// One time of the tracks after the other, from a file or made here.
class Source {
 public:
  explicit Source(const SynthesisRequest& r) {
    TracerSpec tracers = r.tracers;
    tracers.clearance = 0.5 * r.diameter;
    tracers.apart = 2 * r.diameter;  // particles do not lie in each other
    const bool folder = std::filesystem::is_directory(r.source);
    const std::string table = folder ? r.source + "/tracks.csv" : r.source;
    if (folder && std::filesystem::exists(r.source + "/fields.xdmf")) {
      field = read_flow(r.source);
    }
    if (std::filesystem::exists(table)) {
      reader_.emplace(table);
    } else if (field) {
      made_ = make_tracers(*field, tracers);
    } else {
      throw InputError(r.source + ": holds neither tracks.csv nor fields.xdmf");
    }
  }

  bool next(std::vector<TrackRow>& rows) {
    if (reader_) {
      return reader_->next(rows);
    }
    if (at_ == made_.size()) {
      return false;
    }
    rows = made_[at_++];
    return true;
  }

  std::optional<FlowField> field;

 private:
  std::optional<TrackReader> reader_;
  std::vector<std::vector<TrackRow>> made_;
  std::size_t at_ = 0;
};

/// Images or a video.
class FrameWriter {
 public:
  FrameWriter(const SynthesisRequest& r, cv::Size size, Real frame_rate) : folder_(r.output_dir) {
    if (r.avi) {
      avi_.open(folder_ + "/video.avi", cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), frame_rate,
                size, false);
      if (!avi_.isOpened()) {
        throw RunError("cannot write " + folder_ + "/video.avi");
      }
    } else {
      make_folder(folder_ + "/frames");
    }
  }
  void write(int frame, const cv::Mat& picture) {
    if (avi_.isOpened()) {
      avi_.write(picture);
    } else if (!cv::imwrite(fmt::format("{}/frames/{:06}.png", folder_, frame), picture,
                            {cv::IMWRITE_PNG_COMPRESSION, 1})) {
      throw RunError("cannot write into " + folder_ + "/frames");
    }
  }

 private:
  std::string folder_;
  cv::VideoWriter avi_;
};

void fit_frame(const SynthesisRequest& r, const Source& source, Microscope& m) {
  if (m.width > 0 && m.height > 0) {
    return;
  }
  if (!source.field) {
    throw InputError("--size is missing: the width and the height of the frames in pixels");
  }
  const Vec3 size = source.field->high() - source.field->low();
  m.width = static_cast<int>(std::lround(size.x / r.pixel_size));
  m.height = static_cast<int>(std::lround(size.y / r.pixel_size));
}

std::string track_file(const SynthesisRequest& r, Real frame_rate) {
  return fmt::format(
      "[video]\nframe_rate = \"{} Hz\"\npixel_size = \"{} m\"\n\n[detect]\npolarity = \"{}\"\n",
      frame_rate, r.pixel_size, r.microscope.dark ? "dark" : "bright");
}

}  // namespace

int synthesize(const SynthesisRequest& r) {
  if (!(r.pixel_size > 0)) {
    throw InputError("--pixel-size is missing, such as \"1 um\"");
  }
  Source source(r);
  Microscope m = r.microscope;
  fit_frame(r, source, m);
  const cv::Size size(m.width, m.height);
  cv::Mat grains;
  if (!r.grains.empty()) {
    grains = read_mask(r.grains, size, GrainKind::dark);
  } else if (source.field) {
    grains = grain_picture(*source.field, size, r.pixel_size);
  }
  if (r.depth_of_field > 0) {
    m.depth_of_field = r.depth_of_field / r.pixel_size;
  }
  const Vec3 low = source.field ? source.field->low() : Vec3{};
  const Real focus = source.field ? 0.5 * (low.z + source.field->high().z) : 0;
  make_folder(r.output_dir + "/truth");
  AtomicFile truth(r.output_dir + "/truth/tracks.csv");
  truth.write(track_header());
  const cv::Mat light = still_light(m, grains);
  std::vector<TrackRow> rows;
  std::vector<TrackRow> ahead;
  bool more = source.next(rows);
  bool another = more && source.next(ahead);
  const Real frame_time = another ? ahead.front().time - rows.front().time : r.tracers.frame_time;
  FrameWriter writer(r, size, 1 / frame_time);
  int frame = 0;
  for (; more; ++frame) {
    std::vector<Seen> seen;
    std::string text;
    for (const TrackRow& row : rows) {
      Seen s;
      s.x = (row.x - low.x) / r.pixel_size - 0.5;
      s.y = m.height - 0.5 - (row.y - low.y) / r.pixel_size;
      s.out_of_focus = std::isfinite(row.z) ? (row.z - focus) / r.pixel_size : 0;
      s.diameter = (std::isfinite(row.diameter) && row.diameter > 0 ? row.diameter : r.diameter) /
                   r.pixel_size;
      if (row.state != TrackState::out) {
        seen.push_back(s);
        text += track_line(row);
      }
    }
    truth.write(text);
    writer.write(frame, expose(m, light, seen, frame));
    std::swap(rows, ahead);
    more = another;
    another = more && source.next(ahead);
  }
  truth.commit();
  if (!grains.empty()) {
    write_mat(r.output_dir + "/grains.png", ~grains, io::make_provenance(1, m.seed));
  }
  write_file(r.output_dir + "/track.toml", track_file(r, 1 / frame_time));
  return frame;
}

}  // namespace porefines::vision
