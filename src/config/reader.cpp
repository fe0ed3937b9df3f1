// SPDX-License-Identifier: MPL-2.0
#include "config/reader.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "config/checks.hpp"
#include "config/key.hpp"
#include "core/error.hpp"

namespace porefines::config {
namespace {

/// The names that may stand in a table of this version: "grid." -> cell_size, cells, decomposition.
std::vector<std::string> names_in(const std::string& prefix) {
  std::vector<std::string> names;
  for (const Key& key : all_keys()) {
    if (key.read && key.path.starts_with(prefix)) {
      const std::string rest = key.path.substr(prefix.size());
      const std::string name = rest.substr(0, rest.find('.'));
      if (std::find(names.begin(), names.end(), name) == names.end()) {
        names.push_back(name);
      }
    }
  }
  return names;
}

/// "cell_size belongs in [grid]" for a known key in the wrong table.
std::string home_of(const std::string& name) {
  for (const Key& key : all_keys()) {
    const auto dot = key.path.find('.');
    if (dot != std::string::npos && key.path.substr(dot + 1) == name) {
      return fmt::format("{} belongs in [{}]", name, key.path.substr(0, dot));
    }
    if (dot == std::string::npos && key.path == name) {
      return fmt::format("{} belongs at the top of the file, before the first [table]", name);
    }
  }
  return {};
}

/// Fails on the first key, in file order, that no line of the table knows.
void require_known(const Node& node, const std::string& prefix) {
  for (const Entry& entry : std::get<Table>(node.value)) {
    const std::string path = prefix + entry.name;
    const Place& place = entry.node.place;
    const auto key = std::find_if(all_keys().begin(), all_keys().end(),
                                  [&](const Key& known) { return known.path == path; });
    if (key != all_keys().end()) {
      if (!key->read) {
        fail(place, "not available in this version", key->doc);
      }
      continue;
    }
    const auto inner = names_in(path + ".");
    if (inner.empty()) {
      fail_unknown(place, entry.name, names_in(prefix), home_of(entry.name));
    }
    if (!std::holds_alternative<Table>(entry.node.value)) {
      fail_wants(entry.node, fmt::format("a table with {} and others", inner.front()));
    }
    require_known(entry.node, path + ".");
  }
}

/// Every face that is neither periodic nor anything else is a no-slip wall.
void add_default_walls(Flow& flow) {
  for (std::size_t face = 0; face < flow.walls.size(); ++face) {
    const auto opens = [&](const std::optional<Opening>& opening) {
      return opening && static_cast<std::size_t>(opening->face) == face;
    };
    if (!flow.periodic[face / 2] && !flow.slip[face] && !opens(flow.inlet) && !opens(flow.outlet)) {
      flow.walls[face] = true;
    }
  }
}

/// An injection that names no species means the only one there is.
void name_the_only_species(Case& subject) {
  for (Injection& injection : subject.injection) {
    if (injection.species.empty() && subject.particles.size() == 1) {
      injection.species = subject.particles.front().name;
    }
  }
}

Case read_tree(const Node& root, const std::string& path) {
  require_known(root, "");
  Case subject;
  subject.path = path;
  for (const Key& key : all_keys()) {
    const Node* node = find(root, key.path);
    if (node == nullptr || !key.read) {
      continue;
    }
    if (!applies(key, subject)) {
      fail(node->place,
           fmt::format("has no meaning for geometry.kind = \"{}\"",
                       geometry_kind_names()[static_cast<std::size_t>(subject.geometry.kind)]),
           "delete the key, or change the kind");
    }
    key.read(subject, *node);
  }
  if (find(root, "flow") == nullptr && !subject.particles.empty()) {
    subject.flow.regime = Regime::none;
  }
  if (is_inertial(subject) && !subject.inertia.steady && find(root, "output") == nullptr) {
    subject.output.push_back({OutputKind::summary});
  }
  if (is_dry(subject) && find(root, "output") == nullptr) {
    subject.output = {{OutputKind::pictures}, {OutputKind::tracks}, {OutputKind::summary}};
  }
  name_the_only_species(subject);
  validate(subject, root);
  if (!is_dry(subject)) {
    add_default_walls(subject.flow);
  }
  return subject;
}

/// Keys of which one makes the others superfluous.
const std::vector<std::vector<std::string>>& alternatives() {
  static const std::vector<std::vector<std::string>> groups{
      {"grid.cell_size", "grid.cells"},
      {"geometry.threshold", "geometry.pore_value"},
      {"flow.inlet.pressure", "flow.inlet.flow_rate", "flow.inlet.velocity"},
      {"flow.outlet.pressure", "flow.outlet.flow_rate", "flow.outlet.velocity"},
      {"flow.pressure_tolerance", "flow.tolerance"}};
  return groups;
}

/// An alternative on the command line takes the place of the one in the file.
void drop_replaced(Node& root) {
  for (const auto& group : alternatives()) {
    const bool replaced = std::any_of(group.begin(), group.end(), [&](const std::string& path) {
      const Node* node = find(root, path);
      return node != nullptr && node->place.command_line;
    });
    for (const std::string& path : group) {
      const Node* node = find(root, path);
      if (replaced && node != nullptr && !node->place.command_line) {
        erase(root, path);
      }
    }
  }
}

Node read_with_overrides(std::string_view text, const std::string& name,
                         const std::vector<std::string>& overrides) {
  Node root = parse_toml(text, name);
  for (const std::string& assignment : overrides) {
    apply_override(root, assignment);
  }
  drop_replaced(root);
  return root;
}

}  // namespace

Case parse_case(std::string_view text, const std::string& name,
                const std::vector<std::string>& overrides) {
  return read_tree(read_with_overrides(text, name, overrides), name);
}

Case load_case(const std::string& path, const std::vector<std::string>& overrides) {
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path)) {
    throw InputError(
        fmt::format("{}: cannot be read; the first argument is a case file in TOML", path));
  }
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const Node root = read_with_overrides(text, path, overrides);
  Case subject = read_tree(root, path);
  const std::string& source = subject.geometry.source;
  if (!source.empty() && !std::filesystem::is_regular_file(source)) {
    const Place place = place_of(root, "geometry.source");
    fail(place, fmt::format("there is no file {}", source),
         place.command_line ? "" : "a relative path starts at the folder of the case file");
  }
  check_particle_files(subject, root);
  return subject;
}

}  // namespace porefines::config
