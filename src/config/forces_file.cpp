// SPDX-License-Identifier: MPL-2.0
#include "config/forces_file.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "config/item_key.hpp"
#include "core/error.hpp"

namespace porefines::config {
namespace {

constexpr Range lengths{0, 1e3, true};
constexpr Range moduli{0, 1e13, true};
constexpr Range potentials{-1, 1};

std::vector<ItemKey<Colloid>> colloid_items() {
  using C = Colloid;
  return {
      quantity_item("hamaker", &C::hamaker, kind::energy, Range{0, 1e-17}, "required",
                    "Hamaker constant of particle and wall across the liquid; 0: no attraction"),
      quantity_item("hamaker_particles", &C::hamaker_particles, kind::energy, Range{0, 1e-17},
                    "that of particle and wall", "of two particles"),
      quantity_item("wavelength", &C::wavelength, kind::length, lengths, "",
                    "of the dispersion, for the retardation; very large: none"),
      quantity_item("zeta_particle", &C::zeta_particle, kind::voltage, potentials, "required",
                    "zeta potential of the particle"),
      quantity_item("zeta_wall", &C::zeta_wall, kind::voltage, potentials, "required",
                    "of walls and grains"),
      choice_item(
          "model", &C::model, {"hhf", "superposition"},
          "double layer: Hogg-Healy-Fuerstenau (constant potential), or linear superposition "
          "for potentials above 60 mV"),
      quantity_item("ionic_strength", &C::ionic_strength, kind::concentration, Range{1e-5, 1e4},
                    "required", "I = 1/2 sum c z^2; that of NaCl is its concentration"),
      quantity_item("temperature", &C::temperature, kind::temperature, Range{200, 600}, "",
                    "also `\"25 degC\"`"),
      quantity_item("permittivity", &C::permittivity, kind::number, Range{1, 1000}, "",
                    "relative; water has 80.1 at 20 and 78.4 at 25 degrees"),
      quantity_item("born_diameter", &C::born_diameter, kind::length, Range{0, 1e-8, true},
                    "no Born repulsion, no primary minimum", "collision diameter, about 0.5 nm"),
      quantity_item("work_of_adhesion", &C::work_of_adhesion, kind::work_per_area,
                    Range{0, 100, true}, "no adhesion", "of surfaces in contact"),
      quantity_item("roughness", &C::roughness, kind::length, Range{0, 1e-3, true}, "smooth",
                    "height of the asperities over which a particle must roll")};
}

std::vector<ItemKey<Fine>> fine_items() {
  return {
      quantity_item("diameter", &Fine::diameter, kind::length, lengths, "required",
                    "of the particle"),
      quantity_item("density", &Fine::density, kind::density, Range{0, 1e5, true}, "",
                    "mass density"),
      quantity_item("young", &Fine::young, kind::pressure, moduli, "no contact radius",
                    "Young's modulus, the true one; wants a work of adhesion"),
      quantity_item("poisson", &Fine::poisson, kind::number, Range{0, 0.5}, "", "Poisson's ratio")};
}

std::vector<ItemKey<WallStiffness>> wall_items() {
  return {quantity_item("wall_young", &WallStiffness::wall_young, kind::pressure, moduli,
                        "that of the particle", "Young's modulus of walls and grains"),
          quantity_item("wall_poisson", &WallStiffness::wall_poisson, kind::number, Range{0, 0.5},
                        "that of the particle", "Poisson's ratio of walls and grains")};
}

std::vector<ItemKey<Fluid>> fluid_items() {
  return {quantity_item("density", &Fluid::density, kind::density, Range{0, 1e5, true}, "",
                        "mass density"),
          quantity_item("viscosity", &Fluid::viscosity, kind::viscosity, Range{1e-6, 1e3}, "",
                        "dynamic viscosity; water at 20 degrees is the default")};
}

std::vector<ItemKey<FilterGrain>> collector_items() {
  using G = FilterGrain;
  return {quantity_item("diameter", &G::diameter, kind::length, lengths, "required in this table",
                        "of the grains of a filter"),
          quantity_item("porosity", &G::porosity, kind::number, Range{0.05, 0.99},
                        "required in this table", "of the filter"),
          quantity_item("velocity", &G::velocity, kind::velocity, Range{0, 10, true},
                        "required in this table", "superficial: flow rate over cross-section")};
}

/// Reads [table]; a key that is still not a number and says "required" is missed.
template <typename Item>
void read_items(Item& item, const Node& root, const std::string& table,
                const std::vector<ItemKey<Item>>& keys) {
  std::vector<std::string> names;
  for (const ItemKey<Item>& key : keys) {
    names.push_back(key.name);
  }
  if (const Node* given = find(root, table)) {
    (void)read_table(*given, names);
  }
  for (const ItemKey<Item>& key : keys) {
    const std::string path = table + "." + key.name;
    if (const Node* node = find(root, path)) {
      key.read(item, *node, Case{});
    } else if (key.absent.starts_with("required")) {
      fail(place_of(root, path), "is required", key.type);
    }
  }
}

template <typename Item>
std::string rows(const std::string& table, const std::vector<ItemKey<Item>>& keys) {
  std::string text;
  for (const ItemKey<Item>& key : keys) {
    const std::string value = key.write(Item{});
    text += fmt::format("| `{}.{}` | {} | {} | {} |\n", table, key.name, key.type,
                        value.empty() ? key.absent : "`" + value + "`", key.doc);
  }
  return text;
}

/// What would be given for nothing.
void check(const ForcesFile& file, const Node& root) {
  if (!std::isnan(file.particles.young) && !(file.colloid.work_of_adhesion > 0)) {
    fail(place_of(root, "particles.young"), "has no use without adhesion",
         "add [colloid] work_of_adhesion = \"50 mJ/m^2\", or take young out");
  }
  if (file.collector && !(file.colloid.hamaker > 0)) {
    fail(place_of(root, "colloid.hamaker"), "is 0: the efficiency of a collector wants attraction",
         "for example \"1e-20 J\", or take [collector] out");
  }
  for (const char* key : {"contact.wall_young", "contact.wall_poisson"}) {
    if (find(root, key) != nullptr && std::isnan(file.particles.young)) {
      fail(place_of(root, key), "has no use without that of the particle",
           "add [particles] young = \"3.4 GPa\"");
    }
  }
}

}  // namespace

ForcesFile parse_forces(const std::string& text, const std::string& path,
                        const std::vector<std::string>& overrides) {
  Node root = parse_toml(text, path);
  for (const std::string& assignment : overrides) {
    apply_override(root, assignment);
  }
  (void)read_table(root, {"colloid", "particles", "contact", "fluid", "collector"});
  ForcesFile file;
  file.path = path;
  read_items(file.colloid, root, "colloid", colloid_items());
  read_items(file.particles, root, "particles", fine_items());
  read_items(file.contact, root, "contact", wall_items());
  read_items(file.fluid, root, "fluid", fluid_items());
  if (find(root, "collector") != nullptr) {
    file.collector.emplace();
    read_items(*file.collector, root, "collector", collector_items());
  }
  check(file, root);
  const auto fill = [](Real& value, Real other) { value = std::isnan(value) ? other : value; };
  fill(file.colloid.hamaker_particles, file.colloid.hamaker);
  fill(file.contact.wall_young, file.particles.young);
  fill(file.contact.wall_poisson, file.particles.poisson);
  return file;
}

ForcesFile load_forces(const std::string& path, const std::vector<std::string>& overrides) {
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path)) {
    throw InputError(fmt::format(
        "{}: cannot be read; the first argument is a file in TOML as docs/forces.md explains it",
        path));
  }
  return parse_forces({std::istreambuf_iterator<char>(file), {}}, path, overrides);
}

std::string forces_reference() {
  return "| key | value | when absent | meaning |\n|---|---|---|---|\n" +
         rows("colloid", colloid_items()) + rows("particles", fine_items()) +
         rows("contact", wall_items()) + rows("fluid", fluid_items()) +
         rows("collector", collector_items());
}

}  // namespace porefines::config
