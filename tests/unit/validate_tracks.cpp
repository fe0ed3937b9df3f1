// SPDX-License-Identifier: MPL-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "core/atomic_file.hpp"
#include "core/read_text.hpp"
#include "support/scratch.hpp"
#include "validate/read_track.hpp"
#include "validate/shipped.hpp"

namespace porefines::validate {
namespace {

Track falling(const std::vector<Real>& heights, const std::vector<Real>& speeds) {
  Track track;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    track.time.push_back(static_cast<Real>(i));
    track.position.push_back({0, 0, heights[i]});
    track.velocity.push_back({0, 0, speeds[i]});
  }
  return track;
}

TEST(ValidateTracks, rows_of_one_particle) {
  const test::Scratch scratch;
  write_file(scratch / "tracks.csv",
             "time_s,id,x_m,y_m,z_m,u_m_s,v_m_s,w_m_s\n0,1,1,2,3,4,5,6\n0,2,0,0,0,0,0,0\n"
             "1,1,2,2,3,4,5,7\n1,1,2,2");
  const Track track = read_track(scratch.path(), 1);
  ASSERT_EQ(track.time.size(), 2U);
  EXPECT_EQ(track.position[1].x, 2);
  EXPECT_EQ(track.velocity[1].z, 7);
  EXPECT_TRUE(read_track(scratch.path(), 3).time.empty());
}

TEST(ValidateTracks, rebound_is_read_where_the_centre_passes) {
  // Passes 1.5 at 3.5 on the way down and, between speeds of 0 and 2, at 1 on the way up.
  const Track both = falling({2, 1, 1, 2}, {-3, -4, 0, 2});
  EXPECT_NEAR(rebound(both, 1.5), 1 / 3.5, 1e-14);
  EXPECT_EQ(rebound(falling({2, 1, 0.5}, {-3, -4, 0}), 1.5), 0);
  EXPECT_TRUE(std::isnan(rebound(falling({2, 3}, {1, 1}), 1.5)));
  EXPECT_EQ(peak_fall(both), 4);
}

TEST(ValidateTracks, phases_follow_each_other) {
  const Track front = falling({0, -1, -2, -3, -4}, {-1, -1, -1, -1, -1});
  const Track rear = falling({2, 0.7, -0.995, -2.5, -4.6}, {-1.3, -1.7, -1.5, -2, -2});
  const Phases found = phases(front, rear, 1);
  EXPECT_EQ(found.drafting, 1);
  EXPECT_EQ(found.kissing, 2);
  EXPECT_EQ(found.tumbling, 4);
  const Phases apart = phases(front, falling({2, 1, 0, -1, -2}, {-1, -1, -1, -1, -1}), 1);
  EXPECT_EQ(apart.drafting + apart.kissing + apart.tumbling, 0);
}

/// A linear spring and its half sine: overlap v sqrt(m/k), force v sqrt(k m), duration pi sqrt(m/k).
TEST(ValidateTracks, impact_of_a_linear_spring) {
  constexpr Real mass = 2;
  constexpr Real spring = 8;  // half a period is pi/2
  constexpr Real step = 1e-3;
  std::vector<Real> time, distance, speed;
  for (Real t = -0.0107; t < 1.6; t += step) {
    const bool touches = t > 0 && t < M_PI / 2;
    const Real after = t < M_PI / 2 ? t : t - M_PI / 2;
    time.push_back(t);
    distance.push_back(5 - (touches ? 3 * std::sin(2 * t) / 2 : t < 0 ? 3 * t : -3 * after));
    speed.push_back(touches ? -3 * std::cos(2 * t) : t < 0 ? -3 : 3);
  }
  const Impact found = impact_of(time, distance, speed, 5, mass);
  EXPECT_NEAR(found.overlap / (3 * std::sqrt(mass / spring)), 1, 1e-5);
  EXPECT_NEAR(found.force / (3 * std::sqrt(spring * mass)), 1, 1e-4);
  EXPECT_NEAR(found.duration / (M_PI * std::sqrt(mass / spring)), 1, 1e-5);
}

TEST(ValidateTracks, cases_inside_the_program_are_those_of_the_folder) {
  const std::string folder = PF_SOURCE_DIR "/cases/tube_migration/";
  for (const std::string file : {"case.toml", "tube.png"}) {
    EXPECT_EQ(shipped("tube_migration/" + file), read_text(folder + file)) << file;
  }
  EXPECT_THROW((void)shipped("no/case.toml"), std::logic_error);
  EXPECT_NE(shipped("tumbling/case.toml").find("Drafting"), std::string::npos);
}

}  // namespace
}  // namespace porefines::validate
