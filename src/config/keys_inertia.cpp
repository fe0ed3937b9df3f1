// SPDX-License-Identifier: MPL-2.0
// Keys of a flow with inertia.
#include "config/item_key.hpp"

namespace porefines::config {
namespace {

/// Written only where it has a meaning.
Key inertial(Key key) {
  key.write = [write = key.write](const Case& c) {
    return is_inertial(c) || c == Case{} ? write(c) : std::string();
  };
  return key;
}

Lid& lid(Case& c) {
  return c.inertia.lid ? *c.inertia.lid : c.inertia.lid.emplace();
}

std::vector<ItemKey<ProbePoint>> probe_items() {
  return {text_item("name", &ProbePoint::name, "its number", "names the columns of series.csv"),
          {"position", "list of three lengths", "a place in the fluid, from the sample's corner",
           [](ProbePoint& p, const Node& node, const Case&) {
             p.position = read_triple(node, kind::length);
           },
           [](const ProbePoint& p) { return write_triple(p.position, kind::length); }}};
}

}  // namespace

std::vector<Key> inertia_keys() {
  constexpr Range courants{0.01, 20};
  constexpr Range speeds{-1e3, 1e3};
  return {
      inertial(choice_key("flow.scheme", &Case::inertia, &Inertia::scheme,
                          {"auto", "linear", "lust"},
                          "interpolation of what the flow carries: second-order linear; LUST, 75 % "
                          "linear and 25 % linear-upwind; auto: LUST where a cell's Reynolds "
                          "number is above 10")),
      inertial(choice_key("flow.time_scheme", &Case::inertia, &Inertia::time_scheme,
                          {"euler", "bdf2", "midpoint"},
                          "first order; second order, damping; second order, energy-conserving")),
      inertial(quantity_key("flow.courant", &Case::inertia, &Inertia::courant, kind::number,
                            courants, "", "largest Courant number |u| dt / dx of a step")),
      inertial(quantity_key("flow.time_step", &Case::inertia, &Inertia::time_step, kind::time,
                            above_zero, "the Courant number decides", "largest step")),
      inertial(quantity_key("flow.disturbance", &Case::inertia, &Inertia::disturbance, kind::number,
                            Range{0, 1}, "",
                            "sideways waves at the start, of the expected speed: wakes that would "
                            "stay symmetric for long begin to shed")),
      {"flow.lid.face", "face, e.g. `\"y+\"`", "a no-slip face that moves in its own plane",
       [](Case& c, const Node& node) {
         lid(c).face = static_cast<BoxFace>(read_choice(node, face_names()));
       },
       [](const Case& c) -> std::string {
         const auto& q = c.inertia.lid;
         return q ? toml_string(face_names()[static_cast<std::size_t>(q->face)]) : "";
       },
       "no moving wall"},
      {"flow.lid.velocity", "list of three velocities", "of that face",
       [=](Case& c, const Node& node) {
         lid(c).velocity = read_triple(node, kind::velocity, speeds);
       },
       [](const Case& c) -> std::string {
         const auto& q = c.inertia.lid;
         return q ? write_triple(q->velocity, kind::velocity) : "";
       },
       "no moving wall"}};
}

Key probe_key() {
  return list_key("probe", &Case::probe, probe_items(),
                  "Places whose velocity and pressure go into series.csv, with `navier-stokes`");
}

}  // namespace porefines::config
