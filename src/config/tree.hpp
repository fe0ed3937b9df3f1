// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "config/place.hpp"

namespace porefines::config {

struct Node;
struct Entry;
using List = std::vector<Node>;
using Table = std::vector<Entry>;
struct Date {};  ///< TOML knows dates and times; no case wants one

/// A TOML value with the place where it was given. Keeps toml++ out of every other file.
struct Node {
  std::variant<Table, List, std::string, bool, std::int64_t, double, Date> value;
  Place place;
};

struct Entry {
  std::string name;
  Node node;
};

/// @param name  how messages call the text: the path of the case file
/// @throws InputError  not TOML, with the line
[[nodiscard]] Node parse_toml(std::string_view text, const std::string& name);

/// Sets or replaces one value: "grid.cell_size=5 um". The value is read as TOML where that is
/// possible, otherwise taken as text.
/// @throws InputError  no '=', an empty key, or a value where a table is expected
void apply_override(Node& root, const std::string& assignment);

/// The node at "flow.inlet.face"; null when it was not given.
[[nodiscard]] const Node* find(const Node& root, std::string_view path);

/// Takes away what is there.
void erase(Node& root, std::string_view path);

/// Where a key was given; for an absent one the place of the innermost table that should hold it.
[[nodiscard]] Place place_of(const Node& root, std::string_view path);

}  // namespace porefines::config
