// SPDX-License-Identifier: MPL-2.0
// porefines track from end to end, and what it says about bad videos.
#include <csignal>
#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "cli/run_support.hpp"
#include "core/atomic_file.hpp"
#include "vision/scenes.hpp"

namespace porefines::vision {
namespace {

using porefines::test::ProgramResult;
using porefines::test::read_text;

class Pipeline : public ::testing::Test {
 protected:
  /// 30 walkers and 3 stuck particles on 200 x 160 pixels.
  void film(int frames, int particles = 30) const {
    Microscope m;
    m.width = 200;
    m.height = 160;
    const cv::Mat light = still_light(m, {});
    const auto w = test::flow_walkers({m.width, m.height}, std::max(particles, 1), frames, 0.2);
    make_folder(folder_ / "v");
    for (int f = 0; f < frames; ++f) {
      std::vector<Seen> seen;
      if (particles > 0) {
        for (const Spot& s : w.frames[static_cast<std::size_t>(f)]) {
          seen.push_back({s.x, s.y, 0, 4});
        }
        for (const Real x : {20.0, 90.0, 170.0}) {
          seen.push_back({x, 80, 0, 4});
        }
      }
      cv::imwrite(frame(f), expose(m, light, seen, f));
    }
  }
  [[nodiscard]] std::string frame(int f) const { return folder_ / fmt::format("v/{:04}.png", f); }
  [[nodiscard]] ProgramResult track(const std::vector<std::string>& more,
                                    const std::string& video = "v") const {
    std::vector<std::string> words{"track", video, "video.pixel_size=1 um", "--no-video"};
    words.insert(words.end(), more.begin(), more.end());
    return porefines::test::porefines_in(folder_.path(), words);
  }
  [[nodiscard]] std::string table(const std::string& out) const {
    return read_text(folder_ / (out + "/tracks.csv"));
  }

  porefines::test::Scratch folder_;
  std::string rate_ = "video.frame_rate=10 Hz";
};

TEST_F(Pipeline, gives_the_same_for_any_number_of_threads_and_after_an_interruption) {
  film(40);
  EXPECT_EQ(track({rate_, "--threads", "1", "-o", "a"}).exit_code, 0);
  EXPECT_EQ(track({rate_, "--threads", "3", "-o", "b"}).exit_code, 0);
  EXPECT_FALSE(table("a").empty());
  EXPECT_EQ(table("a"), table("b"));
  // As after a signal in the middle of a write.
  std::filesystem::resize_file(folder_ / "b/spots.bin",
                               std::filesystem::file_size(folder_ / "b/spots.bin") / 2);
  const ProgramResult again = track({rate_, "--resume", "-o", "b"});
  EXPECT_NE(again.output.find("frames are there from before"), std::string::npos) << again.output;
  EXPECT_EQ(table("a"), table("b"));
  const std::string summary = read_text(folder_ / "a/summary.json");
  EXPECT_EQ(porefines::test::number(summary, "tracks_stuck"), 3);
  EXPECT_GT(porefines::test::number(summary, "particles_per_frame_mean"), 28);  // some cross
}

TEST_F(Pipeline, keeps_what_was_tracked_before_a_bad_frame) {
  film(30);
  write_file(frame(20), read_text(frame(20)).substr(0, 60));  // cut short
  ProgramResult result = track({rate_, "-o", "a"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.output.find("frame 20 (0020.png)"), std::string::npos) << result.output;
  EXPECT_NE(table("a").find("\n1.9,"), std::string::npos) << "frame 19 is there";
  EXPECT_EQ(table("a").find("\n2,"), std::string::npos);
  cv::imwrite(frame(20), cv::Mat(10, 10, CV_8U, cv::Scalar(9)));
  result = track({rate_, "-o", "a"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.output.find("frame 20 (0020.png): 10 x 10 pixels, not 200 x 160"),
            std::string::npos)
      << result.output;
}

TEST_F(Pipeline, says_where_frames_are_empty) {
  film(30);
  cv::imwrite(frame(12), cv::Mat(160, 200, CV_8U, cv::Scalar(80)));
  const ProgramResult result = track({rate_, "-o", "a"});
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_NE(result.output.find("1 frames hold no particles, the first is frame 12"),
            std::string::npos)
      << result.output;
}

TEST_F(Pipeline, ends_with_2_where_there_is_nothing_to_track) {
  film(8, 0);
  ProgramResult result = track({rate_, "detect.least_mass=400", "-o", "a"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.output.find("no particles in frames 0 to 7"), std::string::npos)
      << result.output;
  result = track({"-o", "a"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.output.find("does not say how many frames per second"), std::string::npos);
  result = track({rate_}, "nowhere");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.output.find("nowhere: no such video or folder"), std::string::npos);
  write_file(folder_ / "text.avi", "this is no video");
  EXPECT_EQ(track({rate_}, "text.avi").exit_code, 2);
  result = track({rate_, "detect.diametr=4 um"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.output.find("diameter"), std::string::npos) << result.output;
}

TEST_F(Pipeline, stops_at_a_signal_and_keeps_its_tracks) {
  film(60);
  // A folder of many names for the same frames: long enough to be still at work.
  for (int f = 60; f < 3000; ++f) {
    std::filesystem::create_hard_link(frame(f % 60), frame(f));
  }
  porefines::test::Background run(
      folder_.path(), {PF_BINARY, "track", "v", "video.pixel_size=1 um", rate_, "--no-video",
                       "--threads", "1", "-o", "a"});
  ASSERT_TRUE(run.wait_for("particles:")) << run.end().output;
  run.send(SIGINT);
  const ProgramResult result = run.end();
  EXPECT_EQ(result.exit_code, 128 + SIGINT) << result.output;
  EXPECT_GT(table("a").size(), 1000U);
  EXPECT_NE(result.output.find("--resume goes on"), std::string::npos) << result.output;
}

}  // namespace
}  // namespace porefines::vision
