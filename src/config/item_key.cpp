// SPDX-License-Identifier: MPL-2.0
#include "config/item_key.hpp"

#include <filesystem>

#include <fmt/format.h>

namespace porefines::config {

const Node& item_node(const Node& given, const std::string& path, std::size_t index) {
  const Node* node = path.empty() ? &given : find(given, path);
  const auto* list = node == nullptr ? nullptr : std::get_if<List>(&node->value);
  return list != nullptr ? (*list)[index] : node != nullptr ? *node : given;
}

Triple read_triple(const Node& node, const QuantityKind& wanted, Range range) {
  const std::string one = wanted.si_unit.empty() ? "1" : toml_string(std::string(wanted.example));
  const std::string example = fmt::format("[{}, {}, {}]", one, one, one);
  const List& list = read_list(node, example);
  if (list.size() != 3) {
    fail(node.place, fmt::format("has {} components, needs 3: {}", list.size(), example));
  }
  return {read_quantity(list[0], wanted, range), read_quantity(list[1], wanted, range),
          read_quantity(list[2], wanted, range)};
}

std::string write_triple(const Triple& value, const QuantityKind& quantity_kind) {
  return fmt::format("[{}, {}, {}]", toml_quantity(value[0], quantity_kind),
                     toml_quantity(value[1], quantity_kind),
                     toml_quantity(value[2], quantity_kind));
}

std::string read_path(const Node& node, const Case& c) {
  namespace fs = std::filesystem;
  const fs::path given = read_text(node);
  if (given.empty()) {
    fail(node.place, "is empty, name a file");
  }
  const fs::path folder = node.place.command_line ? fs::path() : fs::path(c.path).parent_path();
  return fs::absolute(folder / given).lexically_normal();
}

Region read_region(const Node& node) {
  constexpr auto example =
      "{ low = [\"0 mm\", \"0 mm\", \"1 mm\"], high = [\"1 mm\", \"1 mm\", \"2 mm\"] }";
  (void)read_table(node, {"low", "high"});
  const Node* low = find(node, "low");
  const Node* high = find(node, "high");
  if (low == nullptr || high == nullptr) {
    fail(node.place, "needs both corners, low and high", example);
  }
  const Region region{read_triple(*low, kind::length), read_triple(*high, kind::length)};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(region.low[axis] < region.high[axis])) {
      fail(node.place,
           fmt::format("is empty along {}: low = {:.6g} m, high = {:.6g} m", axis_names()[axis],
                       region.low[axis], region.high[axis]),
           "low is the corner with the smaller coordinates");
    }
  }
  return region;
}

std::string write_region(const std::optional<Region>& region) {
  return region ? fmt::format("{{ low = {}, high = {} }}", write_triple(region->low, kind::length),
                              write_triple(region->high, kind::length))
                : "";
}

}  // namespace porefines::config
