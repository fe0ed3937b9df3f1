// SPDX-License-Identifier: MPL-2.0
// Video files that end early or change: the frame is named, what was tracked before it is kept.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "cli/run_support.hpp"
#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "vision/scenes.hpp"
#include "vision/track.hpp"

namespace porefines::vision {
namespace {

constexpr int frames = 24;

class BrokenVideo : public ::testing::Test {
 protected:
  static std::vector<cv::Mat> film(int width, int height) {
    Microscope m;
    m.width = width;
    m.height = height;
    const cv::Mat light = still_light(m, {});
    const auto w = test::flow_walkers({width, height}, 12, frames, 0.15);
    std::vector<cv::Mat> out;
    for (int f = 0; f < frames; ++f) {
      std::vector<Seen> seen;
      for (const Spot& s : w.frames[static_cast<std::size_t>(f)]) {
        seen.push_back({s.x, s.y, 0, 4});
      }
      out.push_back(expose(m, light, seen, f));
    }
    return out;
  }

  /// Exit code; what it said is in said_.
  int track_file(const std::string& name, const std::vector<std::string>& more = {}) {
    std::vector<std::string> overrides{"video.pixel_size=1 um", "video.annotate=false"};
    overrides.insert(overrides.end(), more.begin(), more.end());
    TrackRequest request;
    request.video = folder_ / name;
    request.output_dir = folder_ / "out";
    request.settings = load_track("", overrides);
    const int code = track(request);
    said_ = porefines::test::read_text(folder_ / "out/log.txt");
    return code;
  }

  /// Last time in tracks.csv, in frames.
  [[nodiscard]] int last_frame(Real rate) const {
    std::ifstream table(folder_ / "out/tracks.csv");
    std::string line;
    std::string last;
    while (std::getline(table, line)) {
      last = line;
    }
    return static_cast<int>(std::lround(std::stod(last) * rate));
  }

  porefines::test::Scratch folder_;
  std::string said_;
};

TEST_F(BrokenVideo, truncated_file) {
  cv::VideoWriter writer(folder_ / "v.avi", cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 10,
                         {96, 64}, false);
  for (const cv::Mat& frame : film(96, 64)) {
    writer.write(frame);
  }
  writer.release();
  EXPECT_EQ(track_file("v.avi"), 0);
  EXPECT_EQ(last_frame(10), frames - 1);
  const auto bytes = std::filesystem::file_size(folder_ / "v.avi");
  std::filesystem::resize_file(folder_ / "v.avi", bytes / 2);
  EXPECT_EQ(track_file("v.avi"), 2);
  const int kept = last_frame(10) + 1;
  EXPECT_GT(kept, frames / 4);
  EXPECT_LT(kept, 3 * frames / 4);
  EXPECT_NE(said_.find("frame " + std::to_string(kept) + ": the video ends here"),
            std::string::npos)
      << said_;
  EXPECT_NE(said_.find("24 frames"), std::string::npos) << said_;
}

/// Pictures one after the other, as a camera's motion JPEG: no header knows how many or how large.
TEST_F(BrokenVideo, size_that_changes_inside_a_file) {
  std::ofstream file(folder_ / "v.mjpeg", std::ios::binary);
  constexpr int whole = 10;
  for (int f = 0; f < frames; ++f) {
    std::vector<std::uint8_t> bytes;
    cv::imencode(".jpg", film(96, f < whole ? 64 : 48)[static_cast<std::size_t>(f)], bytes);
    file.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  }
  file.close();
  EXPECT_EQ(track_file("v.mjpeg", {"video.frame_rate=10 Hz"}), 2);
  EXPECT_NE(said_.find("frame 10: 96 x 48 pixels, not 96 x 64 as the first"), std::string::npos)
      << said_;
  EXPECT_EQ(last_frame(10), whole - 1);
}

TEST_F(BrokenVideo, no_frames_a_second) {
  EXPECT_THROW((void)track_file("v.avi", {"video.frame_rate=0 Hz"}), InputError);
}

TEST_F(BrokenVideo, start_behind_the_end) {
  write_file(folder_ / "empty.avi", "");
  EXPECT_THROW((void)track_file("empty.avi", {"video.frame_rate=10 Hz"}), InputError);
  std::filesystem::create_directory(folder_ / "v");
  cv::imwrite(folder_ / "v/0.png", film(96, 64)[0]);
  EXPECT_THROW((void)track_file("v", {"video.frame_rate=10 Hz", "video.start=5"}), InputError);
}

}  // namespace
}  // namespace porefines::vision
