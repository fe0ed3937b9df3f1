// SPDX-License-Identifier: MPL-2.0
// Detection on pictures whose particles are known.
#include "vision/detect.hpp"

#include <gtest/gtest.h>

#include "vision/estimate.hpp"
#include "vision/scenes.hpp"

namespace porefines::vision {
namespace {

using test::random_particles;

/// Frames of 100 particles on 512 x 512 with the truth, one path per particle and frame.
struct Known {
  std::vector<cv::Mat> frames;
  std::vector<Path> truth;
};

Known known(const Microscope& m, int frames, int particles) {
  Known out;
  const cv::Mat light = still_light(m, {});
  for (int f = 0; f < frames; ++f) {
    const auto seen = random_particles(m, particles, static_cast<std::uint64_t>(f));
    out.frames.push_back(expose(m, light, seen, f));
    for (const Seen& p : seen) {
      out.truth.push_back({{f, p.x, p.y}});
    }
  }
  return out;
}

Agreement agreement(const Known& k, const DetectSettings& s) {
  std::vector<Path> found;
  for (std::size_t f = 0; f < k.frames.size(); ++f) {
    for (const Spot& spot : detect(k.frames[f], {}, s)) {
      found.push_back({{static_cast<int>(f), spot.x, spot.y}});
    }
  }
  return measure(k.truth, found);
}

/// What is found of these in one picture.
Agreement agreement_on(const Microscope& m, const std::vector<Seen>& seen) {
  Known k;
  k.frames.push_back(expose(m, still_light(m, {}), seen, 0));
  for (const Seen& p : seen) {
    k.truth.push_back({{0, p.x, p.y}});
  }
  return agreement(k, estimate(k.frames, {}, {}));
}

Microscope square() {
  Microscope m;
  m.width = m.height = 512;
  return m;
}

TEST(Detect, finds_bright_and_dark_particles_by_itself) {
  for (const bool dark : {false, true}) {
    Microscope m = square();
    m.dark = dark;
    m.background = dark ? 160 : 90;
    const Known k = known(m, 3, 100);
    const DetectSettings s = estimate(k.frames, {}, {});
    EXPECT_EQ(s.dark, dark);
    EXPECT_NEAR(s.diameter, 8, 1);  // 2 * 1.9 * sqrt(1.2^2 + 1 + 1) + 1
    const Agreement a = agreement(k, s);
    EXPECT_GT(a.jaccard, 0.96);  // some particles lie on top of each other
    EXPECT_LT(a.rmse, 0.25);
  }
}

/// SNR 4 with Poisson noise, as in the ISBI challenge.
TEST(Detect, is_within_a_third_of_a_pixel_at_snr_4) {
  Microscope m = square();
  m.snr = 4;
  m.shot = 1;
  const Known k = known(m, 6, 100);
  const Agreement a = agreement(k, estimate(k.frames, {}, {}));
  EXPECT_GT(a.jaccard, 0.95);
  EXPECT_LT(a.rmse, 0.3);
}

TEST(Detect, separates_particles_that_touch) {
  Microscope m = square();
  m.snr = 20;
  std::vector<Seen> seen;
  for (int i = 0; i < 40; ++i) {
    const Real x = 30 + 60.0 * (i % 8);
    const Real y = 40 + 90.0 * (i / 8);
    seen.push_back({x, y, 0, 6});
    if (i % 2 == 0) {
      seen.push_back({x + 6 * std::cos(0.3 * i), y + 6 * std::sin(0.3 * i), 0, 6});
    }
  }
  const Agreement a = agreement_on(m, seen);
  EXPECT_EQ(a.jaccard, 1);
  EXPECT_LT(a.rmse, 0.12);
}

/// Pairs at 1.8 to 2.5 standard deviations of their images, where the sum has one maximum or hardly two.
TEST(Detect, tells_apart_what_has_one_maximum) {
  Microscope m = square();
  m.snr = 20;
  std::vector<Seen> seen;
  for (int i = 0; i < 40; ++i) {
    const Real x = 30 + 60.0 * (i % 8);
    const Real y = 40 + 90.0 * (i / 8);
    seen.push_back({x, y, 0, 4});
    if (i % 3 == 0) {
      const Real apart = 3.4 + 0.03 * i;
      seen.push_back({x + apart * std::cos(0.3 * i), y + apart * std::sin(0.3 * i), 0, 4});
    }
  }
  const Agreement a = agreement_on(m, seen);
  EXPECT_EQ(a.jaccard, 1);
  EXPECT_LT(a.rmse, 0.25);
}

/// One particle of twice the diameter among the others stays one.
TEST(Detect, leaves_large_particles_whole) {
  Microscope m = square();
  m.snr = 20;
  std::vector<Seen> seen;
  for (int i = 0; i < 40; ++i) {
    const Real x = 30 + 60.0 * (i % 8);
    seen.push_back({x, 40 + 90.0 * (i / 8), 0, i % 10 == 0 ? 8.0 : 4.0});
  }
  const cv::Mat frame = expose(m, still_light(m, {}), seen, 0);
  EXPECT_EQ(detect(frame, {}, estimate(std::vector<cv::Mat>{frame}, {}, {})).size(), seen.size());
}

TEST(Detect, agrees_whichever_way_centres_are_found) {
  const Known k = known(square(), 2, 50);
  DetectWishes wishes;
  for (const auto& [centre, rmse] :
       {std::pair{Centre::contour, 0.35}, {Centre::centroid, 0.2}, {Centre::gaussian, 0.15}}) {
    wishes.centre = centre;
    const Agreement a = agreement(k, estimate(k.frames, {}, wishes));
    EXPECT_GT(a.jaccard, 0.93) << static_cast<int>(centre);
    EXPECT_LT(a.rmse, rmse) << static_cast<int>(centre);
  }
}

TEST(Detect, finds_nothing_where_nothing_is) {
  Microscope m = square();
  m.snr = 4;
  const Known with = known(m, 1, 100);
  const DetectSettings s = estimate(with.frames, {}, {});
  EXPECT_LE(detect(expose(m, still_light(m, {}), {}, 5), {}, s).size(), 1U);
  EXPECT_TRUE(detect(cv::Mat(80, 80, CV_8U, cv::Scalar(90)), {}, s).empty());
}

}  // namespace
}  // namespace porefines::vision
