// SPDX-License-Identifier: MPL-2.0
#include "config/tree.hpp"

#include <algorithm>

namespace porefines::config {

const Node* find(const Node& root, std::string_view path) {
  const auto* table = std::get_if<Table>(&root.value);
  if (table == nullptr) {
    return nullptr;
  }
  const auto dot = path.find('.');
  const std::string_view name = path.substr(0, dot);
  const auto entry = std::find_if(table->begin(), table->end(),
                                  [&](const Entry& candidate) { return candidate.name == name; });
  if (entry == table->end()) {
    return nullptr;
  }
  return dot == path.npos ? &entry->node : find(entry->node, path.substr(dot + 1));
}

void erase(Node& root, std::string_view path) {
  const auto dot = path.find('.');
  const std::string_view name = path.substr(0, dot);
  auto* table = std::get_if<Table>(&root.value);
  if (table == nullptr) {
    return;
  }
  if (dot == path.npos) {
    std::erase_if(*table, [&](const Entry& entry) { return entry.name == name; });
    return;
  }
  for (Entry& entry : *table) {
    if (entry.name == name) {
      erase(entry.node, path.substr(dot + 1));
    }
  }
}

Place place_of(const Node& root, std::string_view path) {
  if (const Node* node = find(root, path)) {
    return node->place;
  }
  Place place = root.place;
  for (auto dot = path.rfind('.'); dot != path.npos; dot = path.substr(0, dot).rfind('.')) {
    if (const Node* table = find(root, path.substr(0, dot))) {
      place = table->place;
      break;
    }
  }
  place.path = path;
  place.shape = Place::Shape::key;
  return place;
}

}  // namespace porefines::config
