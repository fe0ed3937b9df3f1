// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/types.hpp"

namespace porefines::io {

/// A CSV table that grows by one row per sample: header of names, first column the time.
///
/// Numbers are the shortest text that reads back to the same double; NaN and infinity are `nan`
/// and `inf`. Each row reaches the operating system whole before append returns, so an
/// interrupted run loses at most the row being written. Use it on one rank.
class SeriesWriter {
 public:
  /// Starts a new table, replacing what was there.
  /// @throws RunError  when the file cannot be written
  SeriesWriter(std::string path, const std::vector<std::string>& names);

  /// Continues a table: keeps the rows whose time is at most `time`, drops the others and a row
  /// that was cut short. A missing file starts a new table.
  /// @param time  [s]  of the checkpoint that the run restarts from
  /// @throws RunError  when the header there is not `names`
  [[nodiscard]] static SeriesWriter resume(std::string path, const std::vector<std::string>& names,
                                           Real time);

  /// Appends one row; one value per name, in their order.
  /// @throws RunError  on a wrong count, or when the disk is full
  void append(std::span<const Real> values);

  /// Appends lines as they are, all at once; each ends in a newline and begins with the time.
  /// @throws RunError  when the disk is full
  void append_lines(std::string_view lines);

  SeriesWriter(SeriesWriter&& other) noexcept;
  SeriesWriter& operator=(SeriesWriter&& other) = delete;
  SeriesWriter(const SeriesWriter&) = delete;
  SeriesWriter& operator=(const SeriesWriter&) = delete;
  ~SeriesWriter();

 private:
  SeriesWriter(std::string path, std::size_t columns, const std::string& content);

  std::string path_;
  std::size_t columns_;
  int file_ = -1;
};

}  // namespace porefines::io
