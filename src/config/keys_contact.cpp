// SPDX-License-Identifier: MPL-2.0
// Keys of [contact], [box] and [[surface]].
#include <fmt/format.h>

#include "config/item_key.hpp"

namespace porefines::config {
namespace {

constexpr Range frictions{0, 10};
constexpr Range restitutions{0, 1, true};
constexpr Range moduli{0, 1e13, true};
constexpr Range lengths{0, 1e3, true};

/// friction = 0.3, or { particle_particle = 0.3, particle_wall = 0.3 }.
void read_friction(Case& c, const Node& node) {
  if (!std::holds_alternative<Table>(node.value)) {
    c.contact.friction_particle = read_quantity(node, kind::number, frictions);
    c.contact.friction_wall = c.contact.friction_particle;
    return;
  }
  (void)read_table(node, {"particle_particle", "particle_wall"});
  if (const Node* value = find(node, "particle_particle")) {
    c.contact.friction_particle = read_quantity(*value, kind::number, frictions);
  }
  if (const Node* value = find(node, "particle_wall")) {
    c.contact.friction_wall = read_quantity(*value, kind::number, frictions);
  }
}

const std::vector<std::string>& rolling_names() {
  static const std::vector<std::string> names{"none", "constant-torque", "spring-dashpot"};
  return names;
}

/// rolling = { model = "constant-torque", friction = 0.01 }
void read_rolling(Case& c, const Node& node) {
  constexpr auto example = "{ model = \"constant-torque\", friction = 0.01 }";
  (void)read_table(node, {"model", "friction"});
  const Node* model = find(node, "model");
  const Node* friction = find(node, "friction");
  if (model == nullptr) {
    fail(node.place, "needs a model", example);
  }
  c.contact.rolling = static_cast<RollingModel>(read_choice(*model, rolling_names()));
  c.contact.rolling_friction = 0;
  if (friction != nullptr) {
    c.contact.rolling_friction = read_quantity(*friction, kind::number, frictions);
  } else if (c.contact.rolling != RollingModel::none) {
    fail(node.place, "needs a friction", example);
  }
}

std::string write_rolling(const Case& c) {
  return fmt::format("{{ model = \"{}\", friction = {} }}",
                     rolling_names()[static_cast<std::size_t>(c.contact.rolling)],
                     c.contact.rolling_friction);
}

Key box_faces_key(const std::string& name, Faces Box::*member, const std::string& doc) {
  return {"box." + name, "list of faces, e.g. `[\"z-\", \"z+\"]`", doc,
          [=](Case& c, const Node& node) {
            c.box.*member = {};
            read_faces(c.box.*member, node);
          },
          [=](const Case& c) { return write_faces(c.box.*member); }};
}

}  // namespace

std::vector<Key> contact_keys() {
  const auto part = &Case::contact;
  return {
      choice_key("contact.model", part, &Contact::model, {"hertz", "linear"},
                 "the normal force: Hertz with Mindlin's tangential spring, or linear springs"),
      quantity_key("contact.restitution", part, &Contact::restitution, kind::number, restitutions,
                   "", "speed after over speed before a head-on impact"),
      {"contact.friction", "number, or `{ particle_particle = 0.3, particle_wall = 0.3 }`",
       "Coulomb's coefficient, sliding", read_friction,
       [](const Case& c) {
         return fmt::format("{{ particle_particle = {}, particle_wall = {} }}",
                            c.contact.friction_particle, c.contact.friction_wall);
       }},
      {"contact.rolling", "`{ model = \"constant-torque\", friction = 0.01 }`",
       "resistance to rolling; also `\"none\"` and `\"spring-dashpot\"`", read_rolling,
       write_rolling},
      quantity_key("contact.wall_young", part, &Contact::wall_young, kind::pressure, moduli,
                   "that of the particle", "Young's modulus of walls and grains"),
      quantity_key("contact.wall_poisson", part, &Contact::wall_poisson, kind::number,
                   Range{0, 0.5, true}, "that of the particle",
                   "Poisson's ratio of walls and grains"),
      quantity_key("contact.stiffness", part, &Contact::stiffness, kind::stiffness, above_zero,
                   "from the moduli and the top speed", "linear model: the normal spring"),
      choice_key("contact.integrator", part, &Contact::integrator,
                 {"auto", "newton-euler", "overdamped"},
                 "what moves particles: inertia, or the balance of forces in a liquid; auto: the "
                 "second where the Stokes number is below 0.1; without a fluid always the first"),
      integer_key("contact.steps_per_contact", part, &Contact::steps_per_contact, Range{10, 1000},
                  "the step is the shortest contact's duration over this"),
      quantity_key("contact.max_overlap", part, &Contact::max_overlap, kind::number,
                   Range{1e-6, 0.5}, "",
                   "largest overlap allowed, in radii; the run stops when it is exceeded, creeping "
                   "fines in a flow become stiffer instead"),
      quantity_key("contact.top_speed", part, &Contact::top_speed, kind::velocity, above_zero,
                   "found from gravity, the box and the speeds at the start",
                   "largest speed of an impact to expect; the step follows from it"),
  };
}

std::vector<Key> box_keys() {
  return {
      {"box.periodic", "list of axes, e.g. `[\"x\", \"y\"]`",
       "without a flow: axes along which the box repeats",
       [](Case& c, const Node& node) { c.box.periodic = read_axes(node); },
       [](const Case& c) { return write_axes(c.box.periodic); }},
      box_faces_key("open", &Box::open, "without a flow: particles that cross this face leave"),
      box_faces_key("smooth", &Box::smooth,
                    "without a flow: walls without friction; every other face is a wall with it"),
  };
}

Key surface_key() {
  using S = Shape;
  using enum ShapeKind;
  const auto kind_is = [](ShapeKind kind) { return [=](const S& s) { return s.kind == kind; }; };
  const auto round = [](const S& s) { return s.kind == cylinder || s.kind == sphere; };
  std::vector<ItemKey<S>> items{
      text_item("name", &S::name, "none", "for messages"),
      choice_item("kind", &S::kind, {"plane", "cylinder", "sphere", "mesh"}, "what it is"),
      triple_item("point", &S::point, kind::length,
                  "on the plane; on the cylinder's axis; centre; where the mesh's origin is put"),
      only_where(kind_is(plane), triple_item("normal", &S::normal, kind::number,
                                             "plane: into the side of the particles")),
      only_where(kind_is(cylinder),
                 triple_item("axis", &S::axis, kind::number, "cylinder: its direction")),
      quantity_item("radius", &S::radius, kind::length, lengths, "required for both",
                    "cylinder, sphere"),
      only_where(round,
                 flag_item("inside", &S::inside, "cylinder, sphere: particles are inside of it")),
      path_item("source", &S::source, "required for a mesh", "mesh: an STL file"),
      only_where(kind_is(mesh), quantity_item("unit", &S::unit, kind::length, lengths, "",
                                              "mesh: unit of the numbers in the file")),
      triple_item("velocity", &S::velocity, kind::velocity,
                  "of the surface, which itself stays in place: a belt")};
  return list_key("surface", &Case::surface, items, "A wall for particles, besides grains and box");
}

}  // namespace porefines::config
