// SPDX-License-Identifier: MPL-2.0
#include "core/json_read.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/read_text.hpp"

namespace porefines {
namespace {

/// Walks through the text; any surprise ends the reading.
struct Cursor {
  const std::string& text;
  std::size_t at = 0;

  void skip_space() { at = std::min(text.find_first_not_of(" \t\r\n", at), text.size()); }
  [[nodiscard]] bool take(char wanted) {
    skip_space();
    const bool found = at < text.size() && text[at] == wanted;
    at += found ? 1 : 0;
    return found;
  }
};

std::optional<std::string> take_string(Cursor& cursor) {
  if (!cursor.take('"')) {
    return {};
  }
  std::string out;
  for (; cursor.at < cursor.text.size(); ++cursor.at) {
    char c = cursor.text[cursor.at];
    if (c == '"') {
      ++cursor.at;
      return out;
    }
    if (c == '\\' && cursor.at + 1 < cursor.text.size()) {
      c = cursor.text[++cursor.at];
      c = c == 'n' ? '\n' : c == 't' ? '\t' : c;
    }
    out += c;
  }
  return {};
}

std::optional<std::string> take_value(Cursor& cursor) {
  cursor.skip_space();
  if (cursor.at < cursor.text.size() && cursor.text[cursor.at] == '"') {
    return take_string(cursor);
  }
  const std::size_t end = cursor.text.find_first_of(",}\n", cursor.at);
  if (end == std::string::npos || end == cursor.at) {
    return {};
  }
  std::string out = cursor.text.substr(cursor.at, end - cursor.at);
  cursor.at = end;
  return out;
}

}  // namespace

const std::string* FlatJson::find(const std::string& key) const {
  for (const auto& [name, value] : members) {
    if (name == key) {
      return &value;
    }
  }
  return nullptr;
}

Real FlatJson::number(const std::string& key) const {
  const std::string* value = find(key);
  char* end = nullptr;
  const Real number = value == nullptr ? std::nan("") : std::strtod(value->c_str(), &end);
  return value == nullptr || end == value->c_str() ? std::nan("") : number;
}

std::optional<FlatJson> parse_flat_json(const std::string& text) {
  FlatJson out;
  Cursor cursor{text};
  if (!cursor.take('{')) {
    return {};
  }
  if (cursor.take('}')) {
    return out;
  }
  do {
    const auto key = take_string(cursor);
    const auto value = key && cursor.take(':') ? take_value(cursor) : std::nullopt;
    if (!value) {
      return {};
    }
    out.members.emplace_back(*key, *value);
  } while (cursor.take(','));
  return cursor.take('}') ? std::optional(out) : std::nullopt;
}

std::optional<FlatJson> read_flat_json(const std::string& path) {
  return parse_flat_json(read_text(path));
}

}  // namespace porefines
