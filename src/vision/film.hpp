// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <memory>
#include <string>

#include <opencv2/core.hpp>

#include "core/types.hpp"

namespace porefines::vision {

/// The frames of a video file, one after the other, as libav (FFmpeg) decodes them: grey levels come
/// straight from the luma plane, and every frame has the size that it has in the file, which OpenCV's
/// reader hides by stretching. Turned as the container says.
class Film {
 public:
  /// Nothing that libav knows: is_open() is false.
  explicit Film(const std::string& path);
  ~Film();
  Film(Film&&) noexcept;
  Film& operator=(Film&&) noexcept;

  [[nodiscard]] bool is_open() const;
  [[nodiscard]] Real frame_rate() const;  ///< [1/s] 0: the container does not say
  [[nodiscard]] int frames() const;       ///< 0: unknown
  /// The next frame, 8 bits; false at the end, and at a frame that is damaged or cut off.
  [[nodiscard]] bool next(cv::Mat& grey);
  /// As next(), without the picture: not even decoded where every frame stands for itself.
  [[nodiscard]] bool skip();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace porefines::vision
