// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/types.hpp"

namespace porefines::page {

/// A CSV table of a run in memory, by rows of text.
struct Table {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows;

  /// Place of a column; -1: there is none.
  [[nodiscard]] int column(std::string_view name) const;
  /// Numbers of a column; what is no number is NaN.
  [[nodiscard]] std::vector<Real> numbers(int column) const;
};

/// Words of a line between commas. No quotes: the last column of clogging.csv holds blanks, not commas.
[[nodiscard]] std::vector<std::string_view> split_row(std::string_view line);

/// NaN for what is no number.
[[nodiscard]] Real number_of(std::string_view word);

/// Reads a table; nothing when the file is not there.
[[nodiscard]] std::optional<Table> read_table(const std::string& path);

/// Every row of a table that may be larger than the memory; a row that is cut short is passed over.
/// Returns false when the file is not there.
bool for_rows(const std::string& path,
              const std::function<void(const std::vector<std::string>& names,
                                       const std::vector<std::string_view>& row)>& visit);

/// Table as JSON: {"rows": as in the file, "columns": {"name": [numbers]}}, thinned to `most` rows evenly,
/// the last one kept.
[[nodiscard]] std::string columns_json(const Table& table, std::size_t most);

}  // namespace porefines::page
