// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdio>
#include <memory>
#include <string>

#include "vision/guide.hpp"

namespace porefines::vision {

/// The spots of every frame in a file, so that memory does not grow with the video and an interrupted
/// detection goes on where it stopped.
///
/// Binary, this machine's byte order: 64 bytes of fingerprint; per frame its number of spots (int64),
/// that many times x, y, mass, peak (double), and the number again, which a frame that was cut short
/// does not have.
class SpotWriter {
 public:
  /// Starts a new file, or goes on behind the whole frames of one with the same fingerprint.
  /// @param fingerprint  of all that the spots depend on
  /// @throws RunError    the file cannot be written
  SpotWriter(const std::string& path, const std::string& fingerprint, bool resume);

  /// Frames that are there.
  [[nodiscard]] int frames() const { return frames_; }
  void append(const Spots& spots);
  /// So that a reader sees all.
  void flush();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
  int frames_ = 0;
};

/// Reads them in order.
class SpotReader {
 public:
  explicit SpotReader(const std::string& path);
  /// False at the end.
  bool next(Spots& spots);
  /// The next `count` frames without keeping them.
  void skip(int count);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace porefines::vision
