// SPDX-License-Identifier: MPL-2.0
#include "vision/still.hpp"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "vision/estimate.hpp"
#include "vision/scenes.hpp"

namespace porefines::vision {
namespace {

/// Discs as grains, 60 particles that are elsewhere in every frame, 5 that are stuck.
struct Chip {
  Microscope m;
  cv::Mat grains;
  std::vector<Seen> stuck{
      {60, 60, 0, 4}, {300, 30, 0, 4}, {20, 350, 0, 4}, {470, 215, 0, 4}, {610, 400, 0, 4}};
  std::vector<cv::Mat> frames;

  explicit Chip(bool dark, Real grain) {
    m.dark = dark;
    m.background = dark ? 170 : 90;
    m.grain = grain;
    grains = cv::Mat(m.height, m.width, CV_8U, cv::Scalar(0));
    for (const cv::Point c :
         {cv::Point(150, 120), {330, 210}, {520, 110}, {180, 330}, {480, 340}}) {
      cv::circle(grains, c, 70, 255, cv::FILLED);
    }
    const cv::Mat light = still_light(m, grains);
    for (int f = 0; f < 25; ++f) {
      auto seen = stuck;
      for (const Seen& p : test::random_particles(m, 120, static_cast<std::uint64_t>(f))) {
        if (grains.at<std::uint8_t>(cv::Point(static_cast<int>(p.x), static_cast<int>(p.y))) == 0) {
          seen.push_back(p);
        }
      }
      frames.push_back(expose(m, light, seen, f));
    }
  }
};

void expect_known(const Chip& chip) {
  const cv::Mat median = median_light(chip.frames);
  const cv::Mat grains = find_grains(chip.frames, median, GrainKind::automatic, 200);
  ASSERT_FALSE(grains.empty());
  const Real both = cv::countNonZero(grains & chip.grains);
  const Real any = cv::countNonZero(grains | chip.grains);
  EXPECT_GT(both / any, 0.97);
  const DetectSettings s = estimate(chip.frames, {median, grains}, {});
  EXPECT_EQ(s.dark, chip.m.dark);
  int stuck = 0;
  const Still still{without_stuck(median, grains, s, &stuck), grains};
  EXPECT_EQ(stuck, 5);
  // They are found again, in every frame; nothing is found in or at the edge of a grain.
  for (std::size_t f = 0; f < 3; ++f) {
    const auto spots = detect(chip.frames[f], still, s);
    for (const Seen& p : chip.stuck) {
      EXPECT_TRUE(std::any_of(spots.begin(), spots.end(),
                              [&](const Spot& q) { return std::hypot(p.x - q.x, p.y - q.y) < 1; }))
          << p.x << " " << p.y << " frame " << f;
    }
  }
}

TEST(Still, dark_grains_with_bright_particles_and_some_stuck) {
  expect_known(Chip(false, 0.6));
}

TEST(Still, bright_grains_with_dark_particles_and_some_stuck) {
  expect_known(Chip(true, 1.3));
}

/// Channels as narrow as a particle, with crossings a little wider: bright, round and alone between dark grains.
TEST(Still, crossings_of_narrow_pores_are_no_particles) {
  Microscope m;
  m.background = 90;
  m.grain = 0.6;
  cv::Mat grains(m.height, m.width, CV_8U, cv::Scalar(255));
  constexpr int pitch = 60;
  for (int x = pitch; x < m.width; x += pitch) {
    cv::line(grains, {x, 0}, {x, m.height}, 0, 3);
  }
  for (int y = pitch; y < m.height; y += pitch) {
    cv::line(grains, {0, y}, {m.width, y}, 0, 3);
    for (int x = pitch; x < m.width; x += pitch) {
      cv::circle(grains, {x, y}, 4, 0, cv::FILLED);
    }
  }
  const std::vector<Seen> one{{300, 150, 0, 4}};
  std::vector<cv::Mat> frames;
  for (int f = 0; f < 9; ++f) {
    frames.push_back(expose(m, still_light(m, grains), one, f));
  }
  const cv::Mat median = median_light(frames);
  DetectSettings s;
  s.diameter = 7;
  s.separation = 4.2;
  s.threshold = 3;
  s.least_mass = 60;
  int stuck = 0;
  (void)without_stuck(median, grains, s, &stuck);
  EXPECT_EQ(stuck, 1) << "the particle in a channel";
}

TEST(Still, uneven_light_alone_is_no_grain) {
  Microscope m;
  m.uneven = 0.4;
  std::vector<cv::Mat> frames;
  for (int f = 0; f < 9; ++f) {
    frames.push_back(expose(m, still_light(m, {}),
                            test::random_particles(m, 100, static_cast<std::uint64_t>(f)), f));
  }
  EXPECT_TRUE(find_grains(frames, median_light(frames), GrainKind::automatic, 200).empty());
}

}  // namespace
}  // namespace porefines::vision
