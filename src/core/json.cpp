// SPDX-License-Identifier: MPL-2.0
#include "core/json.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace porefines {
namespace {

/// Length of the UTF-8 sequence at the front of `text`; 0 when it is not one.
std::size_t sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const auto follows = [&](std::size_t count) {
    for (std::size_t i = 1; i <= count; ++i) {
      if (i >= text.size() || (byte(i) & 0xC0U) != 0x80U) {
        return false;
      }
    }
    return true;
  };
  const unsigned first = byte(0);
  if (first < 0x80U) {
    return 1;
  }
  if (first >= 0xC2U && first <= 0xDFU && follows(1)) {
    return 2;
  }
  if (first >= 0xE0U && first <= 0xEFU && follows(2)) {
    const bool overlong = first == 0xE0U && byte(1) < 0xA0U;
    const bool surrogate = first == 0xEDU && byte(1) >= 0xA0U;
    return overlong || surrogate ? 0 : 3;
  }
  if (first >= 0xF0U && first <= 0xF4U && follows(3)) {
    const bool overlong = first == 0xF0U && byte(1) < 0x90U;
    const bool too_large = first == 0xF4U && byte(1) >= 0x90U;
    return overlong || too_large ? 0 : 4;
  }
  return 0;
}

}  // namespace

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = sequence_length(text);
    if (length == 0) {
      return false;
    }
    text.remove_prefix(length);
  }
  return true;
}

std::string json_string(std::string_view text) {
  std::string out = "\"";
  while (!text.empty()) {
    const char c = text.front();
    const std::size_t length = sequence_length(text);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (c == '\t') {
      out += "\\t";
    } else if (length == 0) {
      out += "\\ufffd";
    } else if (length == 1 && (static_cast<unsigned char>(c) < 0x20U || c == 0x7f)) {
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      out += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out + '"';
}

void Json::set(std::string_view key, std::string_view text) {
  set_raw(key, json_string(text));
}

void Json::set(std::string_view key, bool value) {
  set_raw(key, value ? "true" : "false");
}

void Json::set(std::string_view key, Real value) {
  set_raw(key, std::isfinite(value) ? fmt::format("{}", value) : "null");
}

std::string Json::text() const {
  std::string out = "{\n";
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const auto& [key, value] = members_[i];
    out += fmt::format("  {}: {}{}\n", json_string(key), value, i + 1 < members_.size() ? "," : "");
  }
  return out + "}\n";
}

void Json::set_raw(std::string_view key, std::string value) {
  const auto same = std::find_if(members_.begin(), members_.end(),
                                 [&](const auto& member) { return member.first == key; });
  if (same != members_.end()) {
    same->second = std::move(value);
  } else {
    members_.emplace_back(key, std::move(value));
  }
}

}  // namespace porefines
