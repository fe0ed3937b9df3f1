// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <memory>
#include <string>

#include "io/png.hpp"
#include "io/provenance.hpp"

namespace porefines::io {

/// An MP4 (H.264, plays in every browser) that grows frame by frame.
///
/// Frames go to `path`.part as they come; finish() completes the file and gives it its name, so that
/// a reader never finds half a movie. Without finish() the destructor deletes the part. Odd sizes
/// lose their last row or column. The provenance line is in the file's comment.
/// Memory: some ten frames, however long the movie. Use it on one rank.
/// Test: unit/io_movie (reads back frame by frame).
class MovieWriter {
 public:
  /// @param frame_rate  frames a second
  /// @throws RunError  when the file or the encoder cannot be opened
  MovieWriter(const std::string& path, int width, int height, int frame_rate,
              const Provenance& provenance, const std::string& title = {});
  ~MovieWriter();
  MovieWriter(MovieWriter&&) noexcept;
  MovieWriter& operator=(MovieWriter&&) = delete;
  MovieWriter(const MovieWriter&) = delete;
  MovieWriter& operator=(const MovieWriter&) = delete;

  /// @throws RunError  when it has not the size of the movie or three channels; full disk
  void add(const PixelView& frame);

  /// @throws RunError  full disk
  void finish();

 private:
  struct Encoder;
  std::unique_ptr<Encoder> encoder_;
};

}  // namespace porefines::io
