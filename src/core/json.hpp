// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/types.hpp"

namespace porefines {

/// A flat JSON object: keys in the order of insertion, one per line.
///
/// Numbers are written with the digits needed to read back the same double; what JSON cannot say
/// (NaN, infinity) becomes null. Setting a key again replaces its value in place.
class Json {
 public:
  void set(std::string_view key, std::string_view text);
  void set(std::string_view key, const char* text) { set(key, std::string_view(text)); }
  void set(std::string_view key, bool value);
  void set(std::string_view key, Real value);
  template <std::integral Integer>
  void set(std::string_view key, Integer value) {
    set_raw(key, std::to_string(value));
  }
  /// A value that is JSON already: an object, a list.
  void set_json(std::string_view key, std::string json) { set_raw(key, std::move(json)); }

  [[nodiscard]] std::string text() const;

 private:
  void set_raw(std::string_view key, std::string value);
  std::vector<std::pair<std::string, std::string>> members_;
};

[[nodiscard]] bool is_utf8(std::string_view text);

/// A JSON string with its quotes; bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string json_string(std::string_view text);

}  // namespace porefines
