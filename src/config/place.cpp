// SPDX-License-Identifier: MPL-2.0
#include "config/place.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace porefines::config {
namespace {

/// "grid.cell_size" as it stands in the file: "[grid] cell_size".
std::string as_in_the_file(const Place& place) {
  const auto dot = place.path.find('.');
  std::string table = place.path.substr(0, dot);
  const bool in_list = table.ends_with("[]");
  if (in_list) {
    table.erase(table.size() - 2);
  }
  if (in_list || (dot == std::string::npos && place.shape == Place::Shape::list_of_tables)) {
    table = fmt::format("[[{}]]", table);
  } else if (dot != std::string::npos || place.shape == Place::Shape::table) {
    table = fmt::format("[{}]", table);
  }
  return dot == std::string::npos ? table : fmt::format("{} {}", table, place.path.substr(dot + 1));
}

}  // namespace

std::string Place::text() const {
  if (command_line) {
    return fmt::format("command line: {}", path);
  }
  std::string where = line > 0 ? fmt::format("{}:{}", file, line) : file;
  return path.empty() ? where : fmt::format("{}: {}", where, as_in_the_file(*this));
}

void fail(const Place& place, const std::string& message, const std::string& hint) {
  throw InputError(
      fmt::format("{}: {}{}{}", place.text(), message, hint.empty() ? "" : "\n", hint));
}

}  // namespace porefines::config
