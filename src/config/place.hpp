// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

namespace porefines::config {

/// Where something was said: a line of the case file, or the command line.
struct Place {
  enum class Shape { key, table, list_of_tables };

  std::string file;
  int line = 0;      ///< 0: somewhere in the file
  std::string path;  ///< "grid.cell_size"; "output[].kind" inside a list of tables
  bool command_line = false;
  Shape shape = Shape::key;

  /// "cases/x.toml:12: [grid] cell_size" or "command line: grid.cell_size".
  [[nodiscard]] std::string text() const;
};

/// @throws InputError  "<place>: <message>", and the hint, when there is one, on a second line
[[noreturn]] void fail(const Place& place, const std::string& message,
                       const std::string& hint = "");

}  // namespace porefines::config
