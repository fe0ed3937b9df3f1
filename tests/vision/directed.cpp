// SPDX-License-Identifier: MPL-2.0
// Tracers in the flow of a micromodel that porefines has computed, filmed, detected and linked.
#include <map>

#include <gtest/gtest.h>

#include "vision/estimate.hpp"
#include "vision/link_video.hpp"
#include "vision/micromodel.hpp"
#include "vision/scenes.hpp"
#include "vision/still.hpp"
#include "vision/tracers.hpp"

namespace porefines::vision {
namespace {

constexpr Real pixel = 1e-6;
const cv::Size frame_size(704, 424);  // the sample and its reservoirs
constexpr int tracers = 120;

struct Film {
  std::vector<Spots> spots;
  std::vector<Path> truth;
};

/// Films tracers whose mean step is `share` of their spacing.
Film film(const FlowField& field, Real share, bool middle) {
  const cv::Mat grains = grain_picture(field, frame_size, pixel);
  const Real pores = frame_size.area() - cv::countNonZero(grains);
  const Real gap = std::sqrt(pores / tracers) * pixel;
  TracerSpec spec;
  spec.count = tracers;
  spec.frames = 60;
  spec.frame_time = share * gap / test::mean_speed(field);
  spec.middle = middle;
  spec.clearance = 2 * pixel;
  Microscope m;
  m.width = frame_size.width;
  m.height = frame_size.height;
  const cv::Mat light = still_light(m, grains);
  std::vector<cv::Mat> frames;
  std::map<Index, Path> truth;
  int f = 0;
  for (const auto& rows : make_tracers(field, spec)) {
    std::vector<Seen> seen;
    for (const TrackRow& row : rows) {
      const Real x = (row.x - field.low().x) / pixel - 0.5;
      const Real y = frame_size.height - 0.5 - row.y / pixel;
      seen.push_back({x, y, 0, 4});
      truth[row.id].push_back({f, x, y});
    }
    frames.push_back(expose(m, light, seen, f++));
  }
  const cv::Mat median = median_light(frames);
  Still still{median, find_grains(frames, median, GrainKind::automatic, 150)};
  const auto some = std::span(frames).subspan(0, 6);
  still.light = without_stuck(median, still.grains, estimate(some, still, {}));
  const DetectSettings s = estimate(some, still, {});
  Film out;
  for (const cv::Mat& frame : frames) {
    out.spots.push_back(detect(frame, still, s));
  }
  for (auto& [id, path] : truth) {
    out.truth.push_back(std::move(path));
  }
  return out;
}

Agreement linked(const Film& film, LinkMethod method, const Guide* known) {
  LinkSettings settings;
  settings.method = method;
  settings.flow = {1, 0};
  settings.range =
      known != nullptr ? reach_of(*known) : estimated_range(film.spots, {}, frame_size);
  const Guide guide =
      known != nullptr ? *known : mean_flow(film.spots, {}, frame_size, settings.range);
  const Learnt learnt = method == LinkMethod::thesis ? Learnt{guide, {}, 0}
                                                     : learn_motion(settings, guide, film.spots,
                                                                    frame_size, known == nullptr);
  Linker linker(settings, learnt.guide, learnt.motion);
  std::map<Index, Path> paths;
  for (std::size_t f = 0; f < film.spots.size(); ++f) {
    const auto ids =
        linker.next(film.spots[f], f + 1 < film.spots.size() ? film.spots[f + 1] : Spots{});
    for (std::size_t i = 0; i < ids.size(); ++i) {
      paths[ids[i]].push_back({static_cast<int>(f), film.spots[f][i].x, film.spots[f][i].y});
    }
  }
  std::vector<Path> found;
  for (auto& [id, path] : paths) {
    if (path.size() >= 2) {
      found.push_back(std::move(path));
    }
  }
  return measure(film.truth, found);
}

/// A step of the run's flow in pixels a frame.
Guide guide_of(const std::string& run, const FlowField& field, Real share) {
  const cv::Mat grains = grain_picture(field, frame_size, pixel);
  const Real gap =
      std::sqrt((frame_size.area() - cv::countNonZero(grains)) / Real{tracers}) * pixel;
  return guide_of_run(run, frame_size, pixel, test::mean_speed(field) / (share * gap));
}

TEST(Directed, flow_through_a_micromodel) {
  const porefines::test::Scratch folder;
  const FlowField field = test::computed_flow(folder);
  for (const auto& [share, least] : {std::pair{0.3, 0.9}, {0.7, 0.85}, {1.2, 0.7}}) {
    const Film f = film(field, share, true);
    const Agreement own = linked(f, LinkMethod::assignment, nullptr);
    const Guide guide = guide_of(folder / "run", field, share);
    const Agreement run = linked(f, LinkMethod::assignment, &guide);
    const Agreement thesis = linked(f, LinkMethod::thesis, nullptr);
    for (const auto& [name, a] : {std::pair{"mean flow", own}, {"run", run}, {"thesis", thesis}}) {
      std::printf("%.1f %-10s alpha %.3f beta %.3f Jaccard %.3f of tracks %.3f rmse %.3f\n", share,
                  name, a.alpha, a.beta, a.jaccard, a.jaccard_tracks, a.rmse);
    }
    EXPECT_GE(run.jaccard_tracks, least) << share;
    // Without a run the mean flow has to be found from the positions, which narrow jets defeat.
    EXPECT_GT(own.jaccard_tracks, 0.85 * least - 0.25 * (share > 1)) << share;
    EXPECT_GT(own.alpha, 1.3 * thesis.alpha) << share;
  }
}

}  // namespace
}  // namespace porefines::vision
