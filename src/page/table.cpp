// SPDX-License-Identifier: MPL-2.0
#include "page/table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

#include "core/json.hpp"
#include "page/pack.hpp"

namespace porefines::page {

int Table::column(std::string_view name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

std::vector<Real> Table::numbers(int column) const {
  std::vector<Real> out;
  out.reserve(rows.size());
  for (const auto& row : rows) {
    out.push_back(column < 0 ? NAN : number_of(row[static_cast<std::size_t>(column)]));
  }
  return out;
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

bool for_rows(const std::string& path,
              const std::function<void(const std::vector<std::string>&,
                                       const std::vector<std::string_view>&)>& visit) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) {
    return false;
  }
  const auto words = split_row(line);
  const std::vector<std::string> names(words.begin(), words.end());
  while (std::getline(file, line)) {
    const auto row = split_row(line);
    if (row.size() == names.size()) {
      visit(names, row);
    }
  }
  return true;
}

std::optional<Table> read_table(const std::string& path) {
  Table table;
  const bool there = for_rows(path, [&](const auto& names, const auto& row) {
    if (table.rows.empty()) {
      table.names = names;
    }
    table.rows.emplace_back(row.begin(), row.end());
  });
  return there ? std::optional(std::move(table)) : std::nullopt;
}

std::string columns_json(const Table& table, std::size_t most) {
  const std::size_t step = std::max<std::size_t>(1, (table.rows.size() + most - 1) / most);
  Json columns;
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    const std::vector<Real> all = table.numbers(static_cast<int>(c));
    std::vector<Real> kept;
    for (std::size_t row = (all.size() + step - 1) % step; row < all.size(); row += step) {
      kept.push_back(all[row]);
    }
    columns.set_json(table.names[c], json_numbers(kept));
  }
  Json out;
  out.set("rows", table.rows.size());
  out.set_json("columns", columns.text());
  return out.text();
}

}  // namespace porefines::page
