// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/types.hpp"

namespace porefines {

/// A flat JSON object as it stood in a file: texts without their quotes, everything else as written.
struct FlatJson {
  std::vector<std::pair<std::string, std::string>> members;

  /// Null when there is no such key.
  [[nodiscard]] const std::string* find(const std::string& key) const;
  /// NaN when there is no such number.
  [[nodiscard]] Real number(const std::string& key) const;
};

/// Reads what Json writes; empty when the file is missing or was cut short.
/// Test: unit/json.
[[nodiscard]] std::optional<FlatJson> read_flat_json(const std::string& path);
[[nodiscard]] std::optional<FlatJson> parse_flat_json(const std::string& text);

}  // namespace porefines
