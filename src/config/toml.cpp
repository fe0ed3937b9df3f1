// SPDX-License-Identifier: MPL-2.0
// The only file that sees toml++ (0.6 s to compile, and linked, not header-only).
#include <algorithm>
#include <regex>
#include <sstream>

#include <toml++/toml.h>

#include "config/tree.hpp"
#include "core/error.hpp"
#include "core/json.hpp"

namespace porefines::config {
namespace {

bool is_bare_key(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  });
}

Node convert(const toml::node& source, Place place);

Table convert_table(const toml::table& source, const Place& place) {
  Table table;
  for (const auto& [key, value] : source) {
    // A quoted key keeps its quotes: "grid.cell_size" in one word is no key of ours.
    const std::string name =
        is_bare_key(key.str()) ? std::string(key.str()) : json_string(key.str());
    Place inner = place;
    inner.path = place.path.empty() ? name : place.path + "." + name;
    inner.line = place.command_line ? 0 : static_cast<int>(key.source().begin.line);
    table.push_back({name, convert(value, inner)});
  }
  std::stable_sort(table.begin(), table.end(), [](const Entry& a, const Entry& b) {
    return a.node.place.line < b.node.place.line;
  });
  return table;
}

List convert_list(const toml::array& source, const Place& place) {
  List list;
  for (const toml::node& element : source) {
    Place inner = place;
    inner.path += element.is_table() ? "[]" : "";
    inner.line = place.command_line ? 0 : static_cast<int>(element.source().begin.line);
    list.push_back(convert(element, inner));
  }
  return list;
}

Node convert(const toml::node& source, Place place) {
  place.shape = Place::Shape::key;
  Node node{Date{}, std::move(place)};
  if (const auto* table = source.as_table()) {
    node.place.shape = Place::Shape::table;
    node.value = convert_table(*table, node.place);
  } else if (const auto* array = source.as_array()) {
    const bool tables = !array->empty() && array->is_homogeneous<toml::table>();
    node.place.shape = tables ? Place::Shape::list_of_tables : Place::Shape::key;
    node.value = convert_list(*array, node.place);
  } else if (const auto* text = source.as_string()) {
    node.value = text->get();
  } else if (const auto* flag = source.as_boolean()) {
    node.value = flag->get();
  } else if (const auto* integer = source.as_integer()) {
    node.value = integer->get();
  } else if (const auto* number = source.as_floating_point()) {
    node.value = number->get();
  }
  return node;
}

std::string line_of(std::string_view text, std::size_t number) {
  std::istringstream lines{std::string(text)};
  std::string line;
  for (std::size_t i = 0; i < number; ++i) {
    std::getline(lines, line);
  }
  return line;
}

/// The commonest error: a quantity without quotes, `pixel_size = 5 um`.
std::string hint_for(const std::string& line) {
  constexpr std::size_t longest = 200;
  static const std::regex bare_quantity(
      R"(^\s*([\w.-]+)\s*=\s*([-+]?[\d.]+[^"',\[{#=]*[^"',\[{#=\s]))");
  std::smatch part;
  if (line.size() > longest || !std::regex_search(line, part, bare_quantity)) {
    return {};
  }
  return "a value with a unit stands in quotes: " + part[1].str() + " = " +
         json_string(part[2].str());
}

/// Replaces or adds the entry `name` of a table.
Node& entry(Table& table, const std::string& name, const Place& place) {
  for (Entry& candidate : table) {
    if (candidate.name == name) {
      return candidate.node;
    }
  }
  table.push_back({name, Node{Table{}, place}});
  return table.back().node;
}

/// Element `name`, a number from 0, of a list of tables: particles.0.diameter.
Node& element(List& list, const std::string& name, Place& place) {
  const bool number = name.size() < 9 && std::all_of(name.begin(), name.end(),
                                                     [](char c) { return c >= '0' && c <= '9'; });
  if (!number || static_cast<std::size_t>(std::stoi(name)) >= list.size()) {
    fail(place, "is a list of " + std::to_string(list.size()) + ", it holds no element " + name,
         "elements are counted from 0");
  }
  place.path += "." + name;
  return list[static_cast<std::size_t>(std::stoi(name))];
}

/// The value of an override: TOML where it can be read so, otherwise the text itself.
Node read_value(const std::string& text, const Place& place) {
  try {
    const toml::table parsed = toml::parse("value = " + text);
    if (parsed.size() == 1 && !parsed.begin()->second.is_date_time() &&
        !parsed.begin()->second.is_date() && !parsed.begin()->second.is_time()) {
      return convert(parsed.begin()->second, place);
    }
  } catch (const toml::parse_error&) {
    // not TOML: a text without its quotes, as the shell left it
  }
  if (!is_utf8(text)) {
    fail(place, "is not UTF-8 text");  // could not be written into the effective case
  }
  return Node{text, place};
}

}  // namespace

Node parse_toml(std::string_view text, const std::string& name) {
  Place place;
  place.file = name;
  place.shape = Place::Shape::table;
  try {
    const toml::table parsed = toml::parse(text, name);
    return Node{convert_table(parsed, place), place};
  } catch (const toml::parse_error& error) {
    place.line = static_cast<int>(error.source().begin.line);
    fail(place, "this is not TOML: " + std::string(error.description()),
         hint_for(line_of(text, error.source().begin.line)));
  }
}

void apply_override(Node& root, const std::string& assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string::npos) {
    throw InputError("command line: \"" + assignment +
                     "\" is no override\nwrite key.path=value, e.g. \"grid.cell_size=5 um\"");
  }
  const std::string path = assignment.substr(0, equals);
  Place place;
  place.command_line = true;
  Node* node = &root;
  for (std::size_t start = 0; start <= path.size();) {
    const auto dot = std::min(path.find('.', start), path.size());
    const std::string name = path.substr(start, dot - start);
    if (!is_bare_key(name)) {
      throw InputError("command line: " + json_string(path) +
                       " is no key\nwrite key.path=value, e.g. \"grid.cell_size=5 um\"");
    }
    start = dot + 1;
    if (auto* list = std::get_if<List>(&node->value)) {
      node = &element(*list, name, place);
      continue;
    }
    auto* table = std::get_if<Table>(&node->value);
    if (table == nullptr) {
      fail(place, "is a single value, it holds no key " + name);
    }
    place.path += (place.path.empty() ? "" : ".") + name;
    place.shape = Place::Shape::table;
    node = &entry(*table, name, place);
  }
  place.shape = Place::Shape::key;
  *node = read_value(assignment.substr(equals + 1), place);
}

}  // namespace porefines::config
