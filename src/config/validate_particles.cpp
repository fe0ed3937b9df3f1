// SPDX-License-Identifier: MPL-2.0
// What holds between the keys of particles, their injection, walls and the run.
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "config/checks.hpp"
#include "config/item_key.hpp"

namespace porefines::config {
namespace {

bool has(const Node& item, const std::string& name) {
  return find(item, name) != nullptr;
}

/// Where a key of an item was given, or is missing.
Place place_in(const Node& item, const std::string& name) {
  if (const Node* node = find(item, name)) {
    return node->place;
  }
  Place place = item.place;
  place.path += "." + name;
  place.shape = Place::Shape::key;
  return place;
}

void check_species(const Case& subject, std::size_t index, const Node& given) {
  const Particles& p = subject.particles[index];
  const Node& item = item_node(given, "particles", index);
  if (p.name.empty()) {
    fail(place_in(item, "name"), "is empty", "name = \"latex\"");
  }
  const auto same_name = [&](const Particles& other) { return other.name == p.name; };
  if (std::count_if(subject.particles.begin(), subject.particles.end(), same_name) > 1) {
    fail(item.place, fmt::format("there are two species called {}", toml_string(p.name)),
         "give each a name of its own");
  }
  if (p.source.empty() && !has(item, "diameter")) {
    fail(item.place, "needs a diameter", "diameter = \"5 um\", or a source with diameter_m");
  }
  const bool dense = p.filling == Filling::dense;
  const int ways = (p.source.empty() ? 0 : 1) + (p.count > 0 ? 1 : 0) + (p.fill > 0 ? 1 : 0);
  if (dense && p.fill > 0) {
    fail(place_in(item, "fill"), "has no meaning for a dense filling, which fills its region",
         "leave it out, or filling = \"loose\"");
  }
  if (ways > 1) {
    fail(item.place, "says twice which particles there are at the start",
         "one of source, count and fill");
  }
  if ((ways == 0 && !dense) || !p.source.empty()) {
    for (const std::string name : {"filling", "region", "velocity"}) {
      if (has(item, name)) {
        fail(place_in(item, name), "has no meaning without count or fill");
      }
    }
  }
  if (p.fixed && (has(item, "force") || p.velocity != Triple{})) {
    fail(place_in(item, has(item, "force") ? "force" : "velocity"),
         "has no meaning for fixed particles");
  }
}

bool injected(const Case& subject, const Particles& species) {
  return std::any_of(subject.injection.begin(), subject.injection.end(),
                     [&](const Injection& injection) { return injection.species == species.name; });
}

void check_amount(const Node& item) {
  int ways = 0;
  for (const std::string name : {"volume_fraction", "mass_fraction", "rate"}) {
    ways += has(item, name) ? 1 : 0;
  }
  if (ways != 1) {
    fail(item.place, ways == 0 ? "does not say how much" : "says twice how much",
         "give one of volume_fraction, mass_fraction and rate");
  }
}

void check_injection(const Case& subject, std::size_t index, const Node& given) {
  const Injection& injection = subject.injection[index];
  const Node& item = item_node(given, "injection", index);
  std::vector<std::string> names;
  for (const Particles& p : subject.particles) {
    names.push_back(p.name);
  }
  if (std::find(names.begin(), names.end(), injection.species) == names.end()) {
    fail(place_in(item, "species"),
         fmt::format("there are no [[particles]] called {}", toml_string(injection.species)),
         names.empty() ? "add a table [[particles]]"
                       : "known: " + fmt::format("{}", fmt::join(names, ", ")));
  }
  check_amount(item);
  if (injection.stop > 0 && injection.stop <= injection.start) {
    fail(place_in(item, "stop"),
         fmt::format("{:.6g} s is not after start, {:.6g} s", injection.stop, injection.start));
  }
  if (subject.box.periodic[static_cast<std::size_t>(axis_of(injection.face))]) {
    fail(place_in(item, "face"),
         fmt::format("{} belongs to a periodic axis",
                     face_names()[static_cast<std::size_t>(injection.face)]),
         "particles enter through a face that is none");
  }
  const bool by_rate = injection.kind == Concentration::rate;
  if (is_dry(subject) && injection.velocity == 0) {
    fail(place_in(item, "velocity"), "is missing: there is no flow that would carry particles in",
         "velocity = \"1 mm/s\"");
  }
  if (by_rate && has(item, "flow_rate")) {
    fail(place_in(item, "flow_rate"), "has no meaning beside rate");
  }
}

void check_shape(const Shape& shape, const Node& item) {
  if (!has(item, "kind")) {
    fail(item.place, "needs a kind", "kind = \"plane\", \"cylinder\", \"sphere\" or \"mesh\"");
  }
  const auto meant_for = [&](const std::string& name, std::initializer_list<ShapeKind> kinds) {
    if (has(item, name) && std::find(kinds.begin(), kinds.end(), shape.kind) == kinds.end()) {
      fail(place_in(item, name), "has no meaning for this kind");
    }
  };
  using enum ShapeKind;
  meant_for("normal", {plane});
  meant_for("axis", {cylinder});
  meant_for("radius", {cylinder, sphere});
  meant_for("inside", {cylinder, sphere});
  meant_for("source", {mesh});
  meant_for("unit", {mesh});
  const bool round = shape.kind == cylinder || shape.kind == sphere;
  if (round && shape.radius <= 0) {
    fail(place_in(item, "radius"), "is missing", "radius = \"1 mm\"");
  }
  if (shape.kind == mesh && shape.source.empty()) {
    fail(place_in(item, "source"), "is missing", "source = \"hopper.stl\"");
  }
  if (shape.kind == mesh && shape.velocity != Triple{}) {
    fail(place_in(item, "velocity"), "of a mesh is not available in this version",
         "planes, cylinders and spheres may move");
  }
  const Triple zero{};
  if ((shape.kind == plane && shape.normal == zero) ||
      (shape.kind == cylinder && shape.axis == zero)) {
    fail(place_in(item, shape.kind == plane ? "normal" : "axis"), "has no direction");
  }
}

void check_box(const Box& box, const Node& given) {
  for (std::size_t face = 0; face < 6; ++face) {
    const std::string& name = face_names()[face];
    for (const auto& [key, faces] : {std::pair{"open", &box.open}, {"smooth", &box.smooth}}) {
      if ((*faces)[face] && box.periodic[face / 2]) {
        fail(place_of(given, std::string("box.") + key),
             fmt::format("face {} belongs to the periodic axis {}", name, axis_names()[face / 2]));
      }
    }
    if (box.open[face] && box.smooth[face]) {
      fail(place_of(given, "box.smooth"), fmt::format("face {} is already in open", name),
           "a face is one thing only");
    }
  }
}

void check_file(const std::string& path, const Place& place) {
  if (!path.empty() && !std::filesystem::is_regular_file(path)) {
    fail(place, fmt::format("there is no file {}", path),
         place.command_line ? "" : "a relative path starts at the folder of the case file");
  }
}

}  // namespace

void check_particles(const Case& subject, const Node& given) {
  for (std::size_t i = 0; i < subject.particles.size(); ++i) {
    check_species(subject, i, given);
    const Particles& p = subject.particles[i];
    const bool placed = p.count > 0 || p.fill > 0 || p.filling == Filling::dense;
    if (p.source.empty() && !placed && !injected(subject, p)) {
      fail(item_node(given, "particles", i).place, "has no particles",
           "give source, count or fill, or an [injection] of this species");
    }
  }
  for (std::size_t i = 0; i < subject.injection.size(); ++i) {
    check_injection(subject, i, given);
  }
  for (std::size_t i = 0; i < subject.surface.size(); ++i) {
    check_shape(subject.surface[i], item_node(given, "surface", i));
  }
  check_box(subject.box, given);
}

void check_particle_files(const Case& subject, const Node& given) {
  for (std::size_t i = 0; i < subject.particles.size(); ++i) {
    check_file(subject.particles[i].source, place_in(item_node(given, "particles", i), "source"));
  }
  for (std::size_t i = 0; i < subject.surface.size(); ++i) {
    check_file(subject.surface[i].source, place_in(item_node(given, "surface", i), "source"));
  }
}

void check_dry(const Case& subject, const Node& given) {
  Flow untouched;
  untouched.regime = Regime::none;
  if (!(subject.flow == untouched)) {
    fail(place_of(given, "flow"), "says more than regime = \"none\", which has no flow",
         "faces of the box are described in [box]");
  }
  if (subject.particles.empty()) {
    fail(place_of(given, "flow.regime"), "\"none\" leaves nothing to simulate",
         "add [[particles]], or a flow");
  }
  if (!(subject.run.end_time > 0)) {
    fail(place_of(given, "run.end_time"), "is missing", "end_time = \"0.1 s\"");
  }
  if (!(subject.coupling == Coupling{})) {
    fail(place_of(given, "coupling"), "has no meaning without a flow");
  }
  if (!(subject.clogging == Clogging{})) {
    fail(place_of(given, "clogging"), "has no meaning without a flow");
  }
  if (subject.contact.integrator == Integrator::overdamped) {
    fail(place_of(given, "contact.integrator"), "\"overdamped\" needs a liquid that resists",
         "\"auto\" or \"newton-euler\" without a flow");
  }
  for (std::size_t i = 0; i < subject.output.size(); ++i) {
    if (find(given, "output") != nullptr && subject.output[i].kind == OutputKind::fields) {
      fail(item_node(given, "output", i).place, "there are no fields without a flow",
           "kinds here: pictures, tracks, summary, movie");
    }
  }
}

void check_coupled(const Case& subject, const Node& given) {
  if (!(subject.run.end_time > 0)) {
    fail(place_of(given, "run.end_time"), "is missing", "end_time = \"0.1 s\"");
  }
  if (!(subject.box == Box{})) {
    fail(place_of(given, "box"), "has no meaning beside a flow, which says what the faces are");
  }
  if (subject.flow.tensor) {
    fail(place_of(given, "flow.tensor"), "is for a flow without particles");
  }
  for (std::size_t i = 0; i < subject.injection.size(); ++i) {
    const BoxFace face = subject.injection[i].face;
    const Node& item = item_node(given, "injection", i);
    const auto opens = [&](const std::optional<Opening>& q) { return q && q->face == face; };
    if (!opens(subject.flow.inlet) && !opens(subject.flow.outlet)) {
      fail(place_in(item, "face"), "is no opening of the flow",
           "particles enter with the fluid, through [flow] inlet");
    }
    for (const std::string name : {"velocity", "flow_rate"}) {
      if (has(item, name)) {
        fail(place_in(item, name), "has no meaning: particles enter as fast as the flow");
      }
    }
  }
}

void check_steady(const Case& subject, const Node& given) {
  const Box untouched;
  if (!subject.injection.empty()) {
    fail(place_of(given, "injection"), "has nothing to inject", "add a table [[particles]]");
  }
  for (const std::string path : {"run.end_time", "run.max_wall", "run.max_pore_volumes",
                                 "run.min_permeability_ratio", "flow.max_pressure"}) {
    if (const Node* node = find(given, path)) {
      fail(node->place, "has no meaning: without particles the steady flow is found in one go");
    }
  }
  if (!(subject.box == untouched)) {
    fail(place_of(given, "box"), "has no meaning beside a flow, which says what the faces are");
  }
  for (const auto& [path, said] : {std::pair{"gravity", subject.gravity != Triple{}},
                                   {"coupling", !(subject.coupling == Coupling{})},
                                   {"clogging", !(subject.clogging == Clogging{})},
                                   {"contact", !(subject.contact == Contact{})},
                                   {"surface", !subject.surface.empty()}}) {
    if (said) {
      fail(place_of(given, path), "is for particles, and there are none");
    }
  }
  for (std::size_t i = 0; i < subject.output.size() && find(given, "output") != nullptr; ++i) {
    const Node& item = item_node(given, "output", i);
    const OutputKind kind = subject.output[i].kind;
    if (kind != OutputKind::fields && kind != OutputKind::pictures) {
      fail(place_in(item, "kind"), "has no meaning for a steady flow",
           kind == OutputKind::summary ? "summary.json is always written, delete this table"
                                       : "there are no moving particles to track");
    }
    if (has(item, "every")) {
      fail(place_in(item, "every"), "has no meaning for a steady flow, which is written once");
    }
  }
}

}  // namespace porefines::config
