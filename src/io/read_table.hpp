// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

#include "core/types.hpp"

namespace porefines::io {

/// A CSV table of ours: a header of names, no quotes.
struct TextTable {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows;

  [[nodiscard]] bool has(const std::string& name) const;
  /// One column as numbers; NaN where there is none.
  [[nodiscard]] std::vector<Real> numbers(const std::string& name) const;
  /// One column as texts; empty where there is none.
  [[nodiscard]] std::vector<std::string> texts(const std::string& name) const;
};

/// Reads the rows that are complete: an interrupted run may have cut the last one short.
/// A file that is missing is a table without names.
[[nodiscard]] TextTable read_table(const std::string& path);

/// @throws InputError  when the table misses one of these columns, or has no row
void require_columns(const TextTable& table, const std::string& path,
                     const std::vector<std::string>& names);

}  // namespace porefines::io
