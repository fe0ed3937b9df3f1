// SPDX-License-Identifier: MPL-2.0
#include "io/read_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "core/error.hpp"

namespace porefines::io {
namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; std::getline(stream, word, ',');) {
    words.push_back(word);
  }
  if (!line.empty() && line.back() == ',') {
    words.emplace_back();
  }
  return words;
}

Real to_number(const std::string& text) {
  char* end = nullptr;
  const Real number = std::strtod(text.c_str(), &end);
  return end == text.c_str() ? std::nan("") : number;
}

}  // namespace

bool TextTable::has(const std::string& name) const {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> TextTable::texts(const std::string& name) const {
  const auto column =
      static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  std::vector<std::string> out;
  for (const auto& row : rows) {
    out.push_back(column < row.size() ? row[column] : "");
  }
  return out;
}

std::vector<Real> TextTable::numbers(const std::string& name) const {
  std::vector<Real> out;
  for (const std::string& text : texts(name)) {
    out.push_back(to_number(text));
  }
  return out;
}

TextTable read_table(const std::string& path) {
  TextTable table;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (file.eof()) {
      break;  // no newline: cut short
    }
    (table.names.empty() ? table.names : table.rows.emplace_back()) = split(line);
  }
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
