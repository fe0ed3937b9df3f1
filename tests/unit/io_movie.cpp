// SPDX-License-Identifier: MPL-2.0
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/videoio.hpp>

#include "core/error.hpp"
#include "io/movie.hpp"
#include "support/scratch.hpp"

namespace porefines::io {
namespace {

constexpr int width = 160;
constexpr int height = 90;

/// A white square that moves by 3 pixels a frame over a blue ramp.
std::vector<std::uint8_t> frame(int n) {
  std::vector<std::uint8_t> rgb;
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      const bool square = std::abs(i - 20 - 3 * n) < 12 && std::abs(j - 45) < 12;
      rgb.push_back(square ? 255 : 30);
      rgb.push_back(square ? 255 : static_cast<std::uint8_t>(i));
      rgb.push_back(square ? 255 : 160);
    }
  }
  return rgb;
}

std::string content(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

const Provenance origin{"9.8.7", "0123456789ab", 2, 5, "2026-01-02T03:04:05Z"};

}  // namespace

TEST(Movie, reads_back_frame_by_frame_with_its_colours_and_origin) {
  const test::Scratch folder;
  const std::string path = folder / "run.mp4";
  MovieWriter movie(path, width, height, 25, origin, "a title");
  constexpr int frames = 40;
  for (int n = 0; n < frames; ++n) {
    movie.add({width, height, 3, frame(n)});
  }
  EXPECT_FALSE(std::filesystem::exists(path));
  movie.finish();
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
  cv::VideoCapture video(path, cv::CAP_FFMPEG);
  ASSERT_TRUE(video.isOpened());
  EXPECT_EQ(video.get(cv::CAP_PROP_FPS), 25);
  cv::Mat picture;
  int n = 0;
  for (; video.read(picture); ++n) {
    ASSERT_EQ(picture.cols, width);
    ASSERT_EQ(picture.rows, height);
    const auto wanted = frame(n);
    double difference = 0;
    for (int j = 0; j < height; ++j) {
      for (int i = 0; i < width; ++i) {
        for (int c = 0; c < 3; ++c) {
          const int at = 3 * (i + width * j) + 2 - c;
          difference += std::abs(picture.at<cv::Vec3b>(j, i)[c] -
                                 static_cast<int>(wanted[static_cast<std::size_t>(at)]));
        }
      }
    }
    EXPECT_LT(difference / (3 * width * height), 6) << n;  // another frame's square: 16 and more
  }
  EXPECT_EQ(n, frames);
  const std::string bytes = content(path);
  EXPECT_NE(bytes.find(describe(origin)), std::string::npos);
  EXPECT_NE(bytes.find("avc1"), std::string::npos);
  EXPECT_LT(bytes.find("moov"), bytes.find("mdat"));  // plays while it loads
}

TEST(Movie, has_the_same_bytes_every_time) {
  const test::Scratch folder;
  for (const char* const name : {"a.mp4", "b.mp4"}) {
    MovieWriter movie(folder / name, width, height, 10, origin);
    for (int n = 0; n < 12; ++n) {
      movie.add({width, height, 3, frame(n)});
    }
    movie.finish();
  }
  EXPECT_EQ(content(folder / "a.mp4"), content(folder / "b.mp4"));
}

TEST(Movie, that_is_not_finished_leaves_nothing) {
  const test::Scratch folder;
  {
    MovieWriter movie(folder / "run.mp4", width, height, 25, origin);
    movie.add({width, height, 3, frame(0)});
    EXPECT_TRUE(std::filesystem::exists(folder / "run.mp4.part"));
    EXPECT_THROW(movie.add({width, height - 8, 3, frame(0)}), RunError);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_THROW(MovieWriter(folder / "missing/run.mp4", width, height, 25, origin), RunError);
  EXPECT_THROW(MovieWriter(folder / "run.mp4", 0, height, 25, origin), RunError);
}

TEST(Movie, on_a_full_disk_says_so) {
  if (!std::filesystem::exists("/dev/full")) {
    GTEST_SKIP() << "no /dev/full";
  }
  const test::Scratch folder;
  std::filesystem::create_symlink("/dev/full", folder / "run.mp4.part");
  EXPECT_THROW(
      {
        MovieWriter movie(folder / "run.mp4", width, height, 25, origin);
        for (int n = 0; n < 200; ++n) {
          movie.add({width, height, 3, frame(n)});
        }
        movie.finish();
      },
      RunError);
  EXPECT_FALSE(std::filesystem::exists(folder / "run.mp4"));
}

}  // namespace porefines::io
