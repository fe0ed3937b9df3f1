// SPDX-License-Identifier: MPL-2.0
#include "vision/detect_video.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/progress.hpp"
#include "core/signals.hpp"
#include "vision/parallel.hpp"
#include "vision/spool.hpp"

namespace porefines::vision {
namespace {

/// Everything that the spots depend on.
std::string fingerprint(const TrackRequest& request, const Prepared& prepared) {
  std::string text = fmt::format("{} {} {}\n", request.video, request.settings.start,
                                 describe(prepared, request.settings.pixel_size));
  for (const cv::Mat& picture : {prepared.still.light, prepared.still.grains}) {
    text += picture.empty() ? "-" : fmt::format("{:.17g} ", cv::norm(picture));
  }
  return text;
}

}  // namespace

DetectedVideo detect_video(Video& video, const Prepared& prepared, const TrackRequest& request,
                           Log& log) {
  const TrackSettings& settings = request.settings;
  DetectedVideo out;
  out.spots = request.output_dir + "/spots.bin";
  SpotWriter writer(out.spots, fingerprint(request, prepared), request.resume);
  if (writer.frames() > 0) {
    log.info("{} frames are there from before", writer.frames());
  }
  int last = settings.stop;
  if (last < 0 && video.frames() > 0) {
    last = video.frames() - 1;
  }
  video.seek(settings.start + writer.frames());
  Progress progress("detect");
  const int batch = 8 * request.threads;
  int empty = 0;
  int first_empty = 0;
  while (out.signal == 0) {
    const int here = settings.start + writer.frames();
    const int wanted = last >= 0 ? std::min(batch, last - here + 1) : batch;
    if (wanted <= 0) {
      break;
    }
    const auto frames = video.read(wanted, request.threads);
    std::vector<Spots> spots(frames.size());
    for_each_index(static_cast<int>(frames.size()), request.threads, [&](int i) {
      const auto k = static_cast<std::size_t>(i);
      spots[k] = detect(frames[k], prepared.still, prepared.detect);
    });
    for (const Spots& found : spots) {
      if (found.empty()) {
        first_empty = empty == 0 ? settings.start + writer.frames() : first_empty;
        ++empty;
      }
      writer.append(found);
    }
    out.problem = video.problem();
    out.signal = caught_signal();
    if (last >= 0) {
      progress.update(static_cast<Real>(writer.frames()) / (last - settings.start + 1));
    }
    if (static_cast<int>(frames.size()) < wanted) {
      break;
    }
  }
  writer.flush();
  out.frames = writer.frames();
  if (empty > 0) {
    log.warn("{} frames hold no particles, the first is frame {}", empty, first_empty);
  }
  return out;
}

}  // namespace porefines::vision
