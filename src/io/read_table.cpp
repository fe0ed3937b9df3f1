// SPDX-License-Identifier: MPL-2.0
#include "io/read_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

#include <fmt/format.h>

#include "core/error.hpp"

namespace porefines::io {
namespace {

/// A line with its newline, without which it was cut short.
bool next_line(std::ifstream& file, std::string& line) {
  return std::getline(file, line) && !file.eof();
}

TextTable head_of(const std::string& line) {
  const auto words = split_row(line);
  return {{words.begin(), words.end()}, {}};
}

}  // namespace

int TextTable::column(std::string_view name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

std::vector<std::string> TextTable::texts(std::string_view name) const {
  const int place = column(name);
  std::vector<std::string> out;
  for (const auto& row : rows) {
    out.push_back(place < 0 ? "" : row[static_cast<std::size_t>(place)]);
  }
  return out;
}

std::vector<Real> TextTable::numbers(std::string_view name) const {
  std::vector<Real> out;
  for (const std::string& text : texts(name)) {
    out.push_back(number_of(text));
  }
  return out;
}

void TextTable::keep_last(std::string_view name) {
  const int place = column(name);
  if (place < 0 || rows.empty()) {
    return;
  }
  const auto at = static_cast<std::size_t>(place);
  const std::string last = rows.back()[at];
  std::erase_if(rows, [&](const auto& row) { return row[at] != last; });
}

std::vector<std::string_view> split_row(std::string_view line) {
  std::vector<std::string_view> words;
  for (;;) {
    const std::size_t comma = line.find(',');
    words.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) {
      return words;
    }
    line.remove_prefix(comma + 1);
  }
}

Real number_of(std::string_view word) {
  Real value = NAN;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc{} && end == word.data() + word.size() ? value : NAN;
}

void for_rows(
    const std::string& path,
    const std::function<void(const TextTable&, const std::vector<std::string_view>&)>& visit) {
  std::ifstream file(path);
  std::string line;
  if (!next_line(file, line)) {
    return;
  }
  const TextTable head = head_of(line);
  while (next_line(file, line)) {
    const auto row = split_row(line);
    if (row.size() == head.names.size()) {
      visit(head, row);
    }
  }
}

TextTable read_table(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  TextTable table = next_line(file, line) ? head_of(line) : TextTable{};
  for_rows(path, [&](const TextTable& /*head*/, const auto& row) {
    table.rows.emplace_back(row.begin(), row.end());
  });
  return table;
}

void require_columns(const TextTable& table, const std::string& path,
                     const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (!table.has(name)) {
      throw InputError(
          fmt::format("{}: {}\nit is written by porefines run with [[output]] kind = "
                      "\"summary\"",
                      path, table.names.empty() ? "cannot be read" : "has no column " + name));
    }
  }
  if (table.rows.empty()) {
    throw InputError(fmt::format("{}: has no rows: the run has not come to a sample yet", path));
  }
}

}  // namespace porefines::io
