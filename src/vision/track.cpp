// SPDX-License-Identifier: MPL-2.0
#include "vision/track.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <optional>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/log.hpp"
#include "core/memory.hpp"
#include "core/progress.hpp"
#include "core/signals.hpp"
#include "vision/detect_video.hpp"
#include "vision/link_video.hpp"
#include "vision/prepare.hpp"
#include "vision/results.hpp"
#include "vision/row_file.hpp"

namespace porefines::vision {
namespace {

Real decided_rate(const TrackSettings& settings, const Video& video, const std::string& name) {
  const Real rate = settings.frame_rate > 0 ? settings.frame_rate : video.frame_rate();
  if (!(rate > 0)) {
    throw InputError(name +
                     ": does not say how many frames per second it has\n"
                     "say [video] frame_rate = \"24 Hz\" in the track file");
  }
  return rate;
}

void require_scale(const TrackSettings& settings) {
  if (!(settings.pixel_size > 0)) {
    throw InputError(
        "video.pixel_size is missing: the edge of a pixel in the sample\n"
        "say [video] pixel_size = \"0.351 um\" in the track file");
  }
}

void write_events(const std::string& folder, const LinkedVideo& linked, const Scale& scale) {
  std::string text = "time_s,id,event,x_m,y_m\n";
  const auto line = [&](int frame, const Rest& rest, const char* what) {
    text += fmt::format("{},{},{},{},{}\n", time_of(scale, frame),
                        linked.kept.number[static_cast<std::size_t>(rest.id)], what,
                        (rest.x + 0.5) * scale.pixel_size,
                        (scale.height - 0.5 - rest.y) * scale.pixel_size);
  };
  for (const Rest& rest : linked.rests) {
    const auto id = static_cast<std::size_t>(rest.id);
    line(rest.first, rest, rest.first > linked.first[id] ? "stuck" : "stuck_from_start");
    if (rest.last < linked.last[id]) {
      line(rest.last, rest, "released");
    }
  }
  write_file(folder + "/events.csv", text);
}

void say_motion(Log& log, const LinkedVideo& linked, const TrackSettings& settings, Real px_speed) {
  if (settings.method == LinkMethod::thesis) {
    log.info("linking: thesis, at most {:.3g} um/s", 1e6 * linked.range * px_speed);
    return;
  }
  log.info(
      "linking: assignment, at most {:.3g} um/s; particles keep {:.0f} % of their own step; off "
      "their prediction by {:.2f} pixels",
      1e6 * linked.range * px_speed, 100 * linked.motion.persistence, linked.motion.deviation);
}

}  // namespace

int track(const TrackRequest& request) {
  const auto began = std::chrono::steady_clock::now();
  const TrackSettings& settings = request.settings;
  require_scale(settings);
  cv::setNumThreads(1);  // frames share the threads, not parts of a frame
  Video video(request.video);
  const Real rate = decided_rate(settings, video, request.video);
  const std::string& folder = request.output_dir;
  make_folder(folder);
  Log log(folder + "/log.txt", &std::cout, request.resume);
  const io::Provenance provenance = io::make_provenance(1, 0);
  log.info("{}", io::describe(provenance));
  log.info("{}: {} x {} pixels, {} frames, {:.4g} frames/s", request.video, video.size().width,
           video.size().height, video.frames() > 0 ? std::to_string(video.frames()) : "unknown",
           rate);
  const Prepared prepared = prepare(request.video, settings);
  log.info("{}", describe(prepared, settings.pixel_size));
  if (!prepared.median.empty()) {
    write_mat(
        folder + "/background.png",
        [&] {
          cv::Mat bytes;
          prepared.median.convertTo(bytes, CV_8U);
          return bytes;
        }(),
        provenance);
  }
  if (!prepared.still.grains.empty()) {
    write_mat(folder + "/grains.png", ~prepared.still.grains, provenance);
  }
  if (request.debug) {
    Stages stages;
    const Spots spots = detect(prepared.sample[0], prepared.still, prepared.detect, &stages);
    write_mat(folder + "/stages.png",
              draw_stages(stages, prepared.still, spots, prepared.detect.diameter), provenance);
    log.info("stages.png shows the first frame");
  }

  const DetectedVideo detected = detect_video(video, prepared, request, log);
  const auto detected_at = std::chrono::steady_clock::now();
  const LinkedVideo linked = link_video(folder, detected, video.size(), settings, rate);
  say_motion(log, linked, settings, settings.pixel_size * rate);
  const Scale scale{settings.pixel_size, 1 / rate, video.size().height, settings.start,
                    settings.diameter > 0 ? settings.diameter : TrackRow::unknown};
  TrackResults results(video.size(), scale);
  write_rows(request, linked, scale, prepared.detect.diameter, results);
  write_events(folder, linked, scale);
  const auto done = std::chrono::steady_clock::now();

  const auto seconds = [](auto a, auto b) { return std::chrono::duration<Real>(b - a).count(); };
  Json summary;
  summary.set("status", detected.signal != 0        ? "interrupted"
                        : !detected.problem.empty() ? "stopped"
                        : linked.tracks == 0        ? "no particles"
                                                    : "done");
  if (!detected.problem.empty()) {
    summary.set("reason", detected.problem);
  }
  summary.set("frames", detected.frames);
  summary.set("tracks", linked.tracks);
  summary.set("tracks_stuck", linked.stuck_tracks);
  summary.set("frame_rate_hz", rate);
  summary.set("pixel_size_m", settings.pixel_size);
  summary.set("width_pixels", video.size().width);
  summary.set("height_pixels", video.size().height);
  summary.set("particle_diameter_pixels", prepared.detect.diameter);
  results.write(folder, prepared.still.grains, provenance, summary);
  summary.set("peak_memory_bytes", peak_memory());
  summary.set("detect_time_s", seconds(began, detected_at));
  summary.set("wall_time_s", seconds(began, std::chrono::steady_clock::now()));
  for (const auto& [name, value] : io::entries(provenance)) {
    summary.set(name, value);
  }
  write_file(folder + "/summary.json", summary.text());
  log.info("{} frames, {} tracks, {} of them stuck at some time; {:.1f} s ({:.0f} frames/s)",
           detected.frames, linked.tracks, linked.stuck_tracks, seconds(began, done),
           detected.frames / std::max(seconds(began, done), 1e-9));
  if (detected.signal != 0) {
    log.warn("interrupted: what was tracked is in {}; --resume goes on", folder);
    return exit_code::signal_base + detected.signal;
  }
  if (!detected.problem.empty()) {
    log.warn("{}: {}\nwhat was tracked before it is in {}", request.video, detected.problem,
             folder);
    return exit_code::wrong_input;
  }
  if (linked.tracks == 0) {
    log.warn(
        "{}: no particles in frames {} to {}\ntry --debug, another detect.polarity, or a lower "
        "detect.least_mass",
        request.video, settings.start, settings.start + detected.frames - 1);
    return exit_code::wrong_input;
  }
  return exit_code::done;
}

}  // namespace porefines::vision
