// SPDX-License-Identifier: MPL-2.0
#include "vision/statistics.hpp"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "core/random.hpp"
#include "vision/align.hpp"
#include "vision/stuck.hpp"

namespace porefines::vision {
namespace {

TrackRow row(Index id, Real x, Real y, Real u = 0) {
  TrackRow r;
  r.id = id;
  r.x = x;
  r.y = y;
  r.u = u;
  r.v = 0;
  return r;
}

TEST(Statistics, of_a_known_square) {
  std::vector<TrackRow> rows{row(1, 0, 0, 1), row(2, 2, 0, 3), row(3, 0, 4, 1), row(4, 2, 4, 3)};
  rows.push_back(row(5, 100, 100, 50));
  rows.back().state = TrackState::retained;
  const Moment m = moment_of(rows, 7);
  EXPECT_EQ(m.particles, 4);
  EXPECT_EQ(m.retained, 1);
  EXPECT_DOUBLE_EQ(m.speed.value, 2);
  EXPECT_DOUBLE_EQ(m.sigma_x.value, 1);
  EXPECT_DOUBLE_EQ(m.sigma_y.value, 2);
  EXPECT_EQ(m.speed.low, moment_of(rows, 7).speed.low);
}

/// The bands hold the true mean as often as those of normal theory, which is exact here.
TEST(Statistics, bands_hold_the_truth) {
  int held = 0;
  int normal = 0;
  for (std::uint64_t k = 0; k < 300; ++k) {
    Draws draws(9, Stream::motion, k);
    std::vector<TrackRow> rows;
    for (Index i = 0; i < 60; ++i) {
      const Real x = draws.normal();
      rows.push_back(row(i, x, draws.normal(), 5 + draws.normal()));
    }
    const Moment m = moment_of(rows, k);
    held += m.speed.low < 5 && 5 < m.speed.high ? 1 : 0;
    Real squares = 0;
    for (const TrackRow& r : rows) {
      squares += (r.u - m.speed.value) * (r.u - m.speed.value);
    }
    normal += std::abs(m.speed.value - 5) < 1.96 * std::sqrt(squares / 59 / 60) ? 1 : 0;
  }
  EXPECT_NEAR(held, normal, 10);  // 200 resamples place a quantile to 1 or 2 %
}

/// Brownian particles with a common drift and badly known centres: D and the error come out.
TEST(Statistics, mean_squares_give_diffusion_and_error) {
  MeanSquares squares(10);
  constexpr Real d = 0.4;
  constexpr Real e = 0.3;
  Draws draws(1, Stream::motion, 2);
  std::vector<cv::Point2d> at(300);
  for (int f = 0; f < 200; ++f) {
    std::vector<TrackRow> rows;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const Real step = std::sqrt(2 * d);
      at[i].x += 3 + step * draws.normal();
      at[i].y += step * draws.normal();
      const Real ex = e * draws.normal();
      rows.push_back(row(static_cast<Index>(i), at[i].x + ex, at[i].y + e * draws.normal()));
    }
    squares.add(f, rows);
  }
  const Diffusion fit = fit_diffusion(squares.result(), 1, 5);
  EXPECT_NEAR(fit.coefficient, d, 0.02 * d);
  EXPECT_NEAR(fit.error, e, 0.1 * e);
}

TEST(Stuck, what_rests_is_told_from_what_creeps_and_what_diffuses) {
  RestFinder finder({});
  Draws draws(2, Stream::motion, 3);
  cv::Point2d brownian(50, 50);
  for (int f = 0; f < 200; ++f) {
    brownian += 0.5 * cv::Point2d(draws.normal(), draws.normal());
    const auto noisy = [&](Real x, Real y) {
      const Real dx = 0.2 * draws.normal();
      return Spot{x + dx, y + 0.2 * draws.normal(), 1, 1};
    };
    finder.add(f,
               {noisy(10, 10), noisy(20 + 0.02 * f, 10), noisy(brownian.x, brownian.y),
                f < 100 ? noisy(30, 10) : noisy(30 + 2.0 * (f - 99), 10)},
               {0, 1, 2, 3});
  }
  const auto rests = finder.finish();
  ASSERT_EQ(rests.size(), 2U);
  EXPECT_EQ(rests[0].id + rests[1].id, 3);
  for (const Rest& rest : rests) {
    EXPECT_EQ(rest.first, 0);
    EXPECT_NEAR(rest.last, rest.id == 0 ? 199 : 99, 1);
    EXPECT_NEAR(rest.x, rest.id == 0 ? 10 : 30, 0.1);
  }
}

TEST(Align, finds_shift_angle_and_scale) {
  cv::Mat run(400, 560, CV_8U, cv::Scalar(0));
  Draws draws(8, Stream::place, 4);
  for (int k = 0; k < 40; ++k) {
    const cv::Point at(static_cast<int>(draws.uniform(0, 560)),
                       static_cast<int>(draws.uniform(0, 400)));
    cv::circle(run, at, static_cast<int>(draws.uniform(12, 40)), 255, cv::FILLED);
  }
  // The video sees 400 x 280 pixels of it: turned by 4 degrees, 5 % larger, from (60, 50) on.
  Alignment truth{60, 50, 4 * CV_PI / 180, 1.05, 1};
  cv::Mat video(280, 400, CV_8U);
  for (int j = 0; j < video.rows; ++j) {
    for (int i = 0; i < video.cols; ++i) {
      const cv::Point2d p = truth.apply({i + 0.5, video.rows - 0.5 - j});
      video.at<std::uint8_t>(j, i) =
          run.at<std::uint8_t>(run.rows - 1 - static_cast<int>(p.y), static_cast<int>(p.x));
    }
  }
  const Alignment found = align(video, run, 1);
  EXPECT_GT(found.overlap, 0.97);
  EXPECT_NEAR(found.angle, truth.angle, 0.004);
  EXPECT_NEAR(found.scale, truth.scale, 0.004);
  const cv::Point2d a = found.apply({200, 140});
  const cv::Point2d b = truth.apply({200, 140});
  EXPECT_NEAR(a.x, b.x, 0.7);
  EXPECT_NEAR(a.y, b.y, 0.7);
}

}  // namespace
}  // namespace porefines::vision
