// SPDX-License-Identifier: MPL-2.0
#include "vision/microscope.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace porefines::vision {
namespace {

cv::Mat shot(const Microscope& m, std::span<const Seen> particles, int frame = 0) {
  return expose(m, still_light(m, {}), particles, frame);
}

TEST(Microscope, has_the_signal_to_noise_ratio_that_was_asked_for) {
  Microscope m;
  m.uneven = 0;
  m.snr = 4;
  m.shot = 0;
  m.contrast = 80;
  cv::Scalar mean;
  cv::Scalar deviation;
  cv::meanStdDev(shot(m, {}), mean, deviation);
  EXPECT_NEAR(mean[0], m.background, 0.2);
  EXPECT_NEAR(m.contrast / deviation[0], 4, 0.04);  // rounding to grey levels adds 1/12
  // With shot noise the ratio holds at the centre of a particle.
  m.shot = 0.5;
  Real sum = 0;
  Real squares = 0;
  constexpr int frames = 2000;
  Microscope small = m;
  small.width = small.height = 9;
  for (int f = 0; f < frames; ++f) {
    const Real v = shot(small, std::vector<Seen>{{4, 4, 0, 4}}, f).at<std::uint8_t>(4, 4);
    sum += v;
    squares += v * v;
  }
  const Real centre = sum / frames;
  EXPECT_NEAR(centre, m.background + m.contrast, 2);
  EXPECT_NEAR(m.contrast / std::sqrt(squares / frames - centre * centre), 4, 0.25);
}

TEST(Microscope, puts_particles_where_they_are) {
  Microscope m;
  m.snr = 0;
  m.uneven = 0;
  for (const bool dark : {false, true}) {
    m.dark = dark;
    m.background = 150;
    cv::Mat light;
    shot(m, std::vector<Seen>{{100.3, 60.8, 0, 4}}).convertTo(light, CV_32F);
    light = (light - 150) * (dark ? -1 : 1);
    const cv::Moments sums = cv::moments(light);
    EXPECT_NEAR(sums.m10 / sums.m00, 100.3, 0.05);
    EXPECT_NEAR(sums.m01 / sums.m00, 60.8, 0.05);
  }
}

TEST(Microscope, spreads_what_is_out_of_focus_and_keeps_its_light) {
  Microscope m;
  m.snr = 0;
  m.uneven = 0;
  m.background = 20;
  m.contrast = 200;
  const cv::Mat sharp = shot(m, std::vector<Seen>{{50, 50, 0, 0}});
  const cv::Mat blurred = shot(m, std::vector<Seen>{{50, 50, m.depth_of_field, 0}});
  EXPECT_EQ(sharp.at<std::uint8_t>(50, 50), 220);
  EXPECT_EQ(blurred.at<std::uint8_t>(50, 50), 120);
  EXPECT_NEAR(cv::sum(sharp - 20)[0] / cv::sum(blurred - 20)[0], 1, 0.03);
}

TEST(Microscope, lights_unevenly_and_shows_grains) {
  Microscope m;
  m.snr = 0;
  cv::Mat grains(m.height, m.width, CV_8U, cv::Scalar(0));
  grains(cv::Rect(300, 200, 60, 60)).setTo(1);
  const cv::Mat light = still_light(m, grains);
  EXPECT_NEAR(light.at<float>(0, 0), m.background, 1e-3);
  EXPECT_NEAR(light.at<float>(m.height - 1, m.width - 1), m.background * (1 - m.uneven), 0.1);
  EXPECT_NEAR(light.at<float>(230, 330) / light.at<float>(230, 280), m.grain, 0.02);
}

TEST(Microscope, repeats_a_frame_bit_for_bit) {
  Microscope m;
  const std::vector<Seen> particles{{10, 10, 3, 4}, {638.7, 423, 0, 5}, {-2, 5, 0, 4}};
  EXPECT_EQ(cv::norm(shot(m, particles, 7), shot(m, particles, 7)), 0);
  EXPECT_GT(cv::norm(shot(m, particles, 7), shot(m, particles, 8)), 0);
}

}  // namespace
}  // namespace porefines::vision
