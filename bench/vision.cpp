// SPDX-License-Identifier: MPL-2.0
// Frames a second of the tracker on one core, whole and stage by stage: 640 x 424 pixels, 370 particles.
//   porefines_bench --benchmark_filter=vision
#include <filesystem>
#include <iostream>
#include <sstream>

#include <benchmark/benchmark.h>
#include <opencv2/videoio.hpp>
#include <unistd.h>

#include "core/random.hpp"
#include "vision/estimate.hpp"
#include "vision/fit.hpp"
#include "vision/link.hpp"
#include "vision/link_video.hpp"
#include "vision/microscope.hpp"
#include "vision/results.hpp"
#include "vision/track.hpp"

namespace porefines::bench {
namespace {

using namespace vision;

constexpr int particles = 370;
constexpr int frames = 40;

/// Brownian particles, filmed.
const std::vector<cv::Mat>& film() {
  static const std::vector<cv::Mat> pictures = [] {
    cv::setNumThreads(1);
    const Microscope m;
    const cv::Mat light = still_light(m, {});
    Draws draws(3, Stream::place, 1);
    std::vector<Seen> seen;
    for (int i = 0; i < particles; ++i) {
      const Real x = draws.uniform(0, m.width);
      seen.push_back({x, draws.uniform(0, m.height), 0, 4});
    }
    std::vector<cv::Mat> out;
    for (int f = 0; f < frames; ++f) {
      out.push_back(expose(m, light, seen, f));
      for (Seen& s : seen) {
        s.x += draws.normal();
        s.y += draws.normal();
      }
    }
    return out;
  }();
  return pictures;
}

const DetectSettings& settings() {
  static const DetectSettings s = estimate(std::span(film()).subspan(0, 4), {}, {});
  return s;
}

const std::vector<Spots>& spots() {
  static const std::vector<Spots> all = [] {
    std::vector<Spots> out;
    for (const cv::Mat& picture : film()) {
      out.push_back(detect(picture, {}, settings()));
    }
    return out;
  }();
  return all;
}

/// The film forth and back, so that it has no jumps, as a video.
std::string video(const std::filesystem::path& folder, int length) {
  const std::string path = folder / "film.avi";
  cv::VideoWriter writer(path, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 24, film()[0].size(),
                         false);
  for (int f = 0; f < length; ++f) {
    const int turn = f % (2 * frames - 2);
    writer.write(film()[static_cast<std::size_t>(turn < frames ? turn : 2 * frames - 2 - turn)]);
  }
  return path;
}

/// A folder that goes with this object.
struct Scratch {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("porefines_bench_" + std::to_string(getpid()));
  Scratch() { std::filesystem::create_directories(path); }
  ~Scratch() { std::filesystem::remove_all(path); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
};

void vision_flatten(benchmark::State& state) {
  std::size_t f = 0;
  (void)settings();
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        flatten(particle_light(film()[f++ % frames], {}, settings()), {}, settings()));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(vision_flatten)->Unit(benchmark::kMillisecond);

void vision_fit(benchmark::State& state) {
  DetectSettings rough = settings();
  rough.centre = Centre::centroid;
  const cv::Mat light = particle_light(film()[0], {}, rough);
  const Spots start = detect(film()[0], {}, rough);
  for (auto _ : state) {
    Spots fitted = start;
    fit_gaussians(light, fitted, rough.diameter);
    benchmark::DoNotOptimize(fitted);
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(vision_fit)->Unit(benchmark::kMillisecond);

void vision_detect(benchmark::State& state) {
  std::size_t f = 0;
  (void)settings();
  for (auto _ : state) {
    benchmark::DoNotOptimize(detect(film()[f++ % frames], {}, settings()));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(vision_detect)->Unit(benchmark::kMillisecond);

void vision_link(benchmark::State& state) {
  LinkSettings link;
  link.range = 15;
  const Learnt learnt = learn_motion(link, mean_flow(spots(), {}, film()[0].size(), link.range),
                                     spots(), film()[0].size(), true);
  for (auto _ : state) {
    Linker linker(link, learnt.guide, learnt.motion);
    for (std::size_t f = 0; f < frames; ++f) {
      benchmark::DoNotOptimize(linker.next(spots()[f], f + 1 < frames ? spots()[f + 1] : Spots{}));
    }
  }
  state.SetItemsProcessed(state.iterations() * frames);
}
BENCHMARK(vision_link)->Unit(benchmark::kMillisecond);

/// Bands, spreads, maps and the lines of tracks.csv.
void vision_results(benchmark::State& state) {
  std::vector<TrackRow> rows;
  for (std::size_t i = 0; i < spots()[0].size(); ++i) {
    TrackRow row;
    row.id = static_cast<Index>(i) + 1;
    row.x = 1e-6 * spots()[0][i].x;
    row.y = 1e-6 * spots()[0][i].y;
    row.u = 1e-6 * spots()[0][i].peak;
    row.v = 1e-7 * spots()[0][i].mass;
    rows.push_back(row);
  }
  TrackResults results(film()[0].size(), {1e-6, 0.04, film()[0].rows, 0, 4e-6});
  int frame = 0;
  for (auto _ : state) {
    std::string text;
    for (const TrackRow& row : rows) {
      text += track_line(row);
    }
    benchmark::DoNotOptimize(text);
    results.add(frame++, rows);
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(vision_results)->Unit(benchmark::kMillisecond);

/// porefines track from a motion-JPEG file to all of its results; argument: with annotated.avi.
void vision_track(benchmark::State& state) {
  constexpr int length = 400;
  const Scratch scratch;
  TrackRequest request;
  request.video = video(scratch.path, length);
  request.output_dir = scratch.path / "out";
  request.settings.pixel_size = 1e-6;
  request.settings.video = state.range(0) != 0;
  std::ostringstream silent;
  auto* const screen = std::cout.rdbuf(silent.rdbuf());
  for (auto _ : state) {
    benchmark::DoNotOptimize(track(request));
  }
  std::cout.rdbuf(screen);
  state.SetItemsProcessed(state.iterations() * length);
}
BENCHMARK(vision_track)->Arg(0)->Arg(1)->Unit(benchmark::kSecond)->Iterations(1);

}  // namespace
}  // namespace porefines::bench
