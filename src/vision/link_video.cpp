// SPDX-License-Identifier: MPL-2.0
#include "vision/link_video.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include "core/error.hpp"
#include "vision/flow_field.hpp"
#include "vision/spool.hpp"

namespace porefines::vision {
namespace {

/// Parts of the video that the motion is learnt from.
struct Parts {
  std::vector<Spots> frames;
  std::vector<bool> breaks;
};

/// Up to six stretches of fifty frames, spread over the video.
Parts read_parts(const DetectedVideo& detected) {
  constexpr int stretches = 6;
  constexpr int length = 50;
  Parts out;
  SpotReader reader(detected.spots);
  Spots spots;
  const bool all = detected.frames <= stretches * length;
  for (int f = 0; f < detected.frames && reader.next(spots); ++f) {
    const int gap = std::max(detected.frames / stretches, 1);
    const bool wanted = all || f % gap < length;
    if (wanted) {
      out.frames.push_back(spots);
      out.breaks.push_back(!all && (f % gap) == length - 1);
    }
  }
  return out;
}

/// The first unbroken stretch, at most this many frames.
std::vector<Spots> first_stretch(const Parts& parts, std::size_t most) {
  std::vector<Spots> out;
  for (std::size_t f = 0; f < parts.frames.size() && out.size() < most; ++f) {
    out.push_back(parts.frames[f]);
    if (parts.breaks[f]) {
      break;
    }
  }
  return out;
}

Learnt learn(const Parts& parts, const LinkSettings& link, const std::optional<Guide>& known,
             cv::Size size) {
  const Guide guide = known ? *known : mean_flow(parts.frames, parts.breaks, size, link.range);
  if (link.method == LinkMethod::thesis) {
    return {guide, {}, 0};
  }
  constexpr std::size_t most = 60;
  return learn_motion(link, guide, first_stretch(parts, most), size, !known);
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

Real reach_of(const Guide& guide) {
  Real reach = 0;
  for (const Step& step : guide.steps) {
    reach = std::max(
        reach, std::hypot(step.mean.x, step.mean.y) + 3 * std::sqrt(std::max(step.xx, step.yy)));
  }
  return reach;
}

Real estimated_range(std::span<const Spots> frames, const std::vector<bool>& breaks,
                     cv::Size size) {
  constexpr Real most = 2.5;
  constexpr Real least = 0.5;
  constexpr Real room = 1.5;  // narrow jets do not fill a cell of the guide
  const Real gap = spacing(frames, size);
  const Real reach = reach_of(mean_flow(frames, breaks, size, most * gap));
  return std::clamp(room * reach, least * gap, most * gap);
}

LinkedVideo link_video(const std::string& folder, const DetectedVideo& detected, cv::Size size,
                       const TrackSettings& settings, Real frame_rate) {
  const Parts parts = read_parts(detected);
  LinkSettings link;
  link.method = settings.method;
  link.memory = settings.memory;
  link.flow = {static_cast<Real>(settings.flow[0]), -static_cast<Real>(settings.flow[1])};
  link.least_slope = settings.least_slope;
  std::optional<Guide> known;
  if (!settings.velocity_field.empty()) {
    known = guide_of_run(settings.velocity_field, size, settings.pixel_size, frame_rate);
  }
  link.range = settings.max_speed > 0 ? settings.max_speed / settings.pixel_size / frame_rate
               : known                ? reach_of(*known)
                                      : estimated_range(parts.frames, parts.breaks, size);
  const Learnt learnt = learn(parts, link, known, size);

  LinkedVideo out;
  out.spots = detected.spots;
  out.ids = folder + "/tracks.bin";
  out.frames = detected.frames;
  out.range = link.range;
  Linker linker(link, learnt.guide, learnt.motion);
  StuckSettings stuck;
  stuck.frames = settings.stuck_time > 0
                     ? std::max(2, static_cast<int>(std::lround(settings.stuck_time * frame_rate)))
                     : std::clamp(detected.frames / 2, 2, stuck.frames);
  RestFinder rests(stuck);
  std::unique_ptr<std::FILE, CloseFile> file(std::fopen(out.ids.c_str(), "wb"));
  if (!file) {
    throw RunError("cannot write " + out.ids);
  }
  SpotReader reader(detected.spots);
  Spots now;
  Spots after;
  std::vector<int> sightings;
  bool more = reader.next(now);
  for (int f = 0; more; ++f) {
    more = reader.next(after);
    const auto ids = linker.next(now, more ? after : Spots{});
    if (std::fwrite(ids.data(), sizeof(Index), ids.size(), file.get()) != ids.size()) {
      throw RunError("cannot write " + out.ids);
    }
    sightings.resize(static_cast<std::size_t>(linker.tracks()), 0);
    out.first.resize(sightings.size(), f);
    out.last.resize(sightings.size(), f);
    for (const Index id : ids) {
      ++sightings[static_cast<std::size_t>(id)];
      out.last[static_cast<std::size_t>(id)] = f;
    }
    rests.add(f, now, ids);
    std::swap(now, after);
  }
  out.motion = linker.motion();
  const int least = std::min(settings.min_length, std::max(detected.frames, 1));
  for (const int count : sightings) {
    out.kept.number.push_back(count >= least ? ++out.tracks : 0);
  }
  for (const Rest& rest : rests.finish()) {
    if (out.kept.number[static_cast<std::size_t>(rest.id)] != 0) {
      out.rests.push_back(rest);
      auto& mine = out.kept.rests[rest.id];
      out.stuck_tracks += mine.empty() ? 1 : 0;
      mine.push_back(rest);
    }
  }
  return out;
}

}  // namespace porefines::vision
