// SPDX-License-Identifier: MPL-2.0
// Frames a second of the tracker on one core: 640 x 424 pixels, 370 particles.
//   porefines_bench --benchmark_filter=vision
#include <benchmark/benchmark.h>

#include "core/random.hpp"
#include "vision/estimate.hpp"
#include "vision/link.hpp"
#include "vision/microscope.hpp"

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
  std::vector<Spots> spots;
  for (const cv::Mat& picture : film()) {
    spots.push_back(detect(picture, {}, settings()));
  }
  LinkSettings link;
  link.range = 15;
  const Learnt learnt = learn_motion(link, mean_flow(spots, {}, film()[0].size(), link.range),
                                     spots, film()[0].size(), true);
  for (auto _ : state) {
    Linker linker(link, learnt.guide, learnt.motion);
    for (std::size_t f = 0; f < spots.size(); ++f) {
      benchmark::DoNotOptimize(linker.next(spots[f], f + 1 < frames ? spots[f + 1] : Spots{}));
    }
  }
  state.SetItemsProcessed(state.iterations() * frames);
}
BENCHMARK(vision_link)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace porefines::bench
