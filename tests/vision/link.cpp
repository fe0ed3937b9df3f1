// SPDX-License-Identifier: MPL-2.0
#include "vision/link.hpp"

#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "vision/scenes.hpp"

namespace porefines::vision {
namespace {

using test::Walkers;

std::vector<Path> link(const std::vector<Spots>& frames, cv::Size size, Real range,
                       LinkMethod method, Motion* motion = nullptr) {
  LinkSettings settings;
  settings.method = method;
  settings.range = range;
  Learnt learnt{known_flow(size, 100, 0, [](const cv::Point2d&) { return cv::Point2d(); }), {}, 0};
  if (method == LinkMethod::assignment) {
    learnt = learn_motion(settings, mean_flow(frames, {}, size, range), frames, size, true);
  }
  Linker linker(settings, learnt.guide, learnt.motion);
  std::map<Index, Path> paths;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const auto ids = linker.next(frames[f], f + 1 < frames.size() ? frames[f + 1] : Spots{});
    for (std::size_t i = 0; i < ids.size(); ++i) {
      paths[ids[i]].push_back({static_cast<int>(f), frames[f][i].x, frames[f][i].y});
    }
  }
  std::vector<Path> out;
  for (auto& [id, path] : paths) {
    if (path.size() > 2) {
      out.push_back(std::move(path));
    }
  }
  if (motion != nullptr) {
    *motion = linker.motion();
  }
  return out;
}

/// Into the test's log: the numbers that the bars are about, of both methods.
void report(const char* name, const Agreement& a) {
  std::printf("%-24s alpha %.3f beta %.3f Jaccard %.3f of tracks %.3f\n", name, a.alpha, a.beta,
              a.jaccard, a.jaccard_tracks);
}

/// Particles that keep their random directions, up to half of the spacing a frame.
TEST(Link, persistent_motion_up_to_half_of_the_spacing) {
  const Walkers w = test::persistent_walkers({512, 512}, 100, 60, 0.5);
  Motion motion;
  const Agreement a =
      measure(w.truth, link(w.frames, {512, 512}, 28, LinkMethod::assignment, &motion));
  report("persistent 0.5", a);
  EXPECT_GT(a.alpha, 0.93);
  EXPECT_GT(a.jaccard_tracks, 0.85);
  EXPECT_GT(motion.persistence, 0.8);
  report("  thesis", measure(w.truth, link(w.frames, {512, 512}, 28, LinkMethod::thesis)));
}

TEST(Link, brownian_motion) {
  const Walkers w = test::brownian_walkers({512, 512}, 100, 60, 0.05);
  Motion motion;
  const Agreement a =
      measure(w.truth, link(w.frames, {512, 512}, 25, LinkMethod::assignment, &motion));
  report("Brownian 0.05", a);
  EXPECT_GT(a.alpha, 0.95);
  EXPECT_LT(motion.persistence, 0.15);
}

/// A winding shear flow: the guide finds where the flow goes although steps exceed the spacing.
TEST(Link, directed_flow_beyond_the_spacing) {
  for (const auto& [share, least] : {std::pair{0.3, 0.9}, {0.7, 0.85}, {1.2, 0.7}}) {
    const Walkers w = test::flow_walkers({640, 424}, 200, 60, share);
    const Real range = 2.2 * share * spacing(w.frames, {640, 424});
    const Agreement a = measure(w.truth, link(w.frames, {640, 424}, range, LinkMethod::assignment));
    report("flow", a);
    EXPECT_GT(a.jaccard_tracks, least) << share;
    const Agreement b = measure(w.truth, link(w.frames, {640, 424}, range, LinkMethod::thesis));
    report("  thesis", b);
  }
}

TEST(Link, bridges_gaps) {
  Walkers w = test::flow_walkers({640, 424}, 100, 40, 0.3);
  Draws draws(5, Stream::place, 1);
  std::vector<Spots> thinned;
  for (const Spots& spots : w.frames) {
    Spots kept;
    for (const Spot& s : spots) {
      if (draws.uniform() > 0.1) {
        kept.push_back(s);
      }
    }
    thinned.push_back(kept);
  }
  const Agreement a = measure(w.truth, link(thinned, {640, 424}, 40, LinkMethod::assignment));
  report("a tenth missing", a);
  EXPECT_GT(a.jaccard_tracks, 0.85);
  EXPECT_GT(a.alpha, 0.85);
}

TEST(Link, thesis_needs_a_slope_against_the_flow) {
  LinkSettings settings;
  settings.method = LinkMethod::thesis;
  settings.range = 10;
  settings.flow = {1, 0};
  const Guide still =
      known_flow({100, 100}, 50, 0, [](const cv::Point2d&) { return cv::Point2d(); });
  const auto linked = [&](const Spot& to) {
    Linker linker(settings, still, {});
    (void)linker.next({{50, 50, 1, 1}}, {});
    return linker.next({to}, {})[0] == 0;
  };
  EXPECT_TRUE(linked({55, 50, 1, 1}));
  EXPECT_FALSE(linked({61, 50, 1, 1})) << "beyond the largest displacement";
  EXPECT_FALSE(linked({45, 50, 1, 1})) << "straight against the flow";
  EXPECT_TRUE(linked({47, 45, 1, 1})) << "round a grain";
}

}  // namespace
}  // namespace porefines::vision
