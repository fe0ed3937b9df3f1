// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace porefines::vision {

enum class TrackState { mobile, retained, out };

/// One row of tracks.csv, of a run or of a video [SI]. What is not known is NaN.
struct TrackRow {
  static constexpr Real unknown = std::numeric_limits<Real>::quiet_NaN();

  Real time = 0;
  Index id = 0;
  Real x = unknown;  ///< y points up
  Real y = unknown;
  Real z = unknown;
  Real u = unknown;
  Real v = unknown;
  Real w = unknown;
  Real diameter = unknown;
  TrackState state = TrackState::mobile;
};

/// The columns that runs and videos share.
[[nodiscard]] const std::string& track_header();

/// A row as text with its newline; what is unknown stays empty.
[[nodiscard]] std::string track_line(const TrackRow& row);

/// Reads tracks.csv time by time: memory does not grow with the file.
///
/// Columns are found by their names; further ones are passed over. Rows of one time must follow one
/// another, times rise.
/// @throws InputError  the file and the line: no such file, a column is missing, not a number
class TrackReader {
 public:
  explicit TrackReader(const std::string& path);
  /// The rows of the next time; false at the end.
  bool next(std::vector<TrackRow>& rows);

 private:
  bool read_row(TrackRow& row);
  [[nodiscard]] int column(const std::string& name, bool needed) const;

  std::string path_;
  std::ifstream file_;
  std::vector<std::string> names_;
  std::vector<int> columns_;
  int line_ = 1;
  bool pending_ = false;
  TrackRow ahead_;
};

}  // namespace porefines::vision
