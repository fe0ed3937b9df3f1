// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/types.hpp"

namespace porefines::io {

/// A CSV table of ours: a header of names, no quotes.
struct TextTable {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows;

  /// Place of a column; -1: there is none.
  [[nodiscard]] int column(std::string_view name) const;
  [[nodiscard]] bool has(std::string_view name) const { return column(name) >= 0; }
  /// One column as numbers; NaN where there is none.
  [[nodiscard]] std::vector<Real> numbers(std::string_view name) const;
  /// One column as texts; empty where there is none.
  [[nodiscard]] std::vector<std::string> texts(std::string_view name) const;
  /// Leaves the rows whose word in this column is that of the last row: the last profile of many.
  void keep_last(std::string_view name);
};

/// Words of a line between commas.
[[nodiscard]] std::vector<std::string_view> split_row(std::string_view line);

/// NaN for what is no number.
[[nodiscard]] Real number_of(std::string_view word);

/// Reads the rows that are complete: an interrupted run may have cut the last one short.
/// A file that is missing is a table without names.
[[nodiscard]] TextTable read_table(const std::string& path);

/// The same row by row, for tables that may be larger than the memory; `head` has no rows.
void for_rows(const std::string& path,
              const std::function<void(const TextTable& head,
                                       const std::vector<std::string_view>& row)>& visit);

/// @throws InputError  when the table misses one of these columns, or has no row
void require_columns(const TextTable& table, const std::string& path,
                     const std::vector<std::string>& names);

}  // namespace porefines::io
