// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "core/types.hpp"
#include "vision/film.hpp"

namespace porefines::vision {

/// The frames of a video file, or of a folder of images in the order of their names, as grey levels.
///
/// Frames are read in order; a folder also gives any frame at any time. Reading ends at the first
/// frame that cannot be used, and problem() says which and why.
class Video {
 public:
  /// @throws InputError  nothing there, no images in the folder, not a video
  explicit Video(const std::string& path);

  [[nodiscard]] cv::Size size() const { return size_; }
  /// As the container says; 0 when it does not. A folder has none.
  [[nodiscard]] Real frame_rate() const { return frame_rate_; }
  /// As the container says; of a folder the number of images; 0: unknown.
  [[nodiscard]] int frames() const { return frames_; }

  /// The next frames, at most `count`; fewer at the end. Images are decoded on `threads` threads.
  [[nodiscard]] std::vector<cv::Mat> read(int count, int threads = 1);
  /// Where the next read() starts.
  void seek(int frame);
  [[nodiscard]] int position() const { return next_; }

  /// Why reading ended before the end: "frame 57 (b_057.png): 320 x 200 pixels, not 640 x 424 as
  /// the first". Empty when it did not.
  [[nodiscard]] const std::string& problem() const { return problem_; }

 private:
  [[nodiscard]] std::vector<cv::Mat> read_images(int count, int threads);
  [[nodiscard]] std::vector<cv::Mat> read_stream(int count);
  void drop_unusable(std::vector<cv::Mat>& frames);
  [[nodiscard]] std::string name_of(int frame) const;

  std::string path_;
  std::vector<std::string> images_;  ///< empty: a video file
  std::optional<Film> film_;
  cv::Size size_;
  Real frame_rate_ = 0;
  int frames_ = 0;
  int next_ = 0;
  std::string problem_;
};

/// Grey levels 0..255 of any picture, as floats.
[[nodiscard]] cv::Mat to_float(const cv::Mat& grey);

/// Reads an image as grey; empty when that fails.
[[nodiscard]] cv::Mat read_grey(const std::string& path);

}  // namespace porefines::vision
