// SPDX-License-Identifier: MPL-2.0
#include <fmt/format.h>

#include "config/item_key.hpp"

namespace porefines::config {
namespace {

constexpr Range gradients{-1e12, 1e12};
constexpr Range pressures{-1e10, 1e10};
constexpr Range flow_rates{0, 1e3};
constexpr Range velocities{0, 1e3};

const std::vector<std::string> regime_names{"stokes", "none", "navier-stokes"};

Key faces_key(std::string path, Faces Flow::*member, std::string doc) {
  return {std::move(path), "list of faces, e.g. `[\"z-\", \"z+\"]`", std::move(doc),
          [=](Case& c, const Node& node) {
            c.flow.*member = {};
            read_faces(c.flow.*member, node);
          },
          [=](const Case& c) { return write_faces(c.flow.*member); }};
}

/// sides = { faces = ["y-", "y+"], kind = "slip" }: another way to say slip or walls.
void read_sides(Case& c, const Node& node) {
  (void)read_table(node, {"faces", "kind"});
  const Node* faces = find(node, "faces");
  const Node* kind = find(node, "kind");
  if (faces == nullptr || kind == nullptr) {
    fail(node.place, "needs both faces and kind", "{ faces = [\"y-\", \"y+\"], kind = \"slip\" }");
  }
  read_faces(read_choice(*kind, {"slip", "wall"}) == 0 ? c.flow.slip : c.flow.walls, *faces);
}

void read_regime(Case& c, const Node& node) {
  c.flow.regime = static_cast<Regime>(read_choice(node, regime_names));
}

void read_steady(Case& c, const Node& node) {
  c.inertia.steady = read_flag(node);
  if (!is_inertial(c) && !c.inertia.steady) {
    fail(node.place, "false has no meaning for a creeping flow, which has no memory",
         "delete the key, or take regime = \"navier-stokes\"");
  }
  c.inertia.steady = c.inertia.steady && is_inertial(c);
}

/// One quantity acts along the first periodic axis, three along x, y, z. Read after `periodic`.
void read_gradient(Case& c, const Node& node) {
  c.flow.pressure_gradient = {};
  const auto* list = std::get_if<List>(&node.value);
  if (list == nullptr) {
    const auto& periodic = c.flow.periodic;
    const std::size_t axis = periodic[0] ? 0 : periodic[1] ? 1 : periodic[2] ? 2 : 0;
    c.flow.pressure_gradient[axis] = read_quantity(node, kind::pressure_gradient, gradients);
    return;
  }
  if (list->size() != 3) {
    fail(node.place, fmt::format("has {} components, needs 3: [\"1 Pa/m\", \"0 Pa/m\", \"0 Pa/m\"]",
                                 list->size()));
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    c.flow.pressure_gradient[axis] =
        read_quantity((*list)[axis], kind::pressure_gradient, gradients);
  }
}

std::string write_gradient(const Case& c) {
  const auto& gradient = c.flow.pressure_gradient;
  const auto part = [&](std::size_t axis) {
    return toml_quantity(gradient[axis], kind::pressure_gradient);
  };
  return gradient == std::array<Real, 3>{} ? ""
                                           : fmt::format("[{}, {}, {}]", part(0), part(1), part(2));
}

/// The keys of `inlet` or `outlet`: the face and one of three drives. That exactly one is given is
/// checked in validate().
std::vector<Key> opening_keys(const std::string& name, std::optional<Opening> Flow::*member) {
  const auto opening = [member](Case& c) -> Opening& {
    auto& place = c.flow.*member;
    return place ? *place : place.emplace();
  };
  const std::string path = "flow." + name + ".";
  const auto drive = [&](const std::string& key, DriveKind drive_kind, const QuantityKind& wanted,
                         Range range, const std::string& doc) {
    return Key{path + key,
               fmt::format("{}, e.g. `\"{}\"`", wanted.name, wanted.example),
               doc,
               [=](Case& c, const Node& node) {
                 Opening& place = opening(c);
                 place.kind = drive_kind;
                 place.value = read_quantity(node, wanted, range);
               },
               [=](const Case& c) -> std::string {
                 const auto& place = c.flow.*member;
                 return place && place->kind == drive_kind ? toml_quantity(place->value, wanted)
                                                           : "";
               },
               "one of three"};
  };
  return {{path + "face", "face, e.g. `\"x-\"`", "the box face of the " + name,
           [=](Case& c, const Node& node) {
             opening(c).face = static_cast<BoxFace>(read_choice(node, face_names()));
           },
           [=](const Case& c) -> std::string {
             const auto& place = c.flow.*member;
             return place ? toml_string(face_names()[static_cast<std::size_t>(place->face)]) : "";
           },
           "no " + name},
          drive("pressure", DriveKind::pressure, kind::pressure, pressures, "mean pressure there"),
          drive("flow_rate", DriveKind::flow_rate, kind::flow_rate, flow_rates,
                "volume per time through the face, as a syringe pump gives it"),
          drive("velocity", DriveKind::velocity, kind::velocity, velocities,
                "uniform normal velocity; with creeping fines the rate that it makes, "
                "as by a pump")};
}

}  // namespace

std::vector<Key> flow_keys() {
  constexpr Range tolerances{1e-14, 0.1};
  std::vector<Key> keys{
      {"flow.regime", "`\"stokes\"`, `\"none\"`, `\"navier-stokes\"`",
       "creeping flow, valid for Re < 1; no fluid at all, which is also what a case with "
       "particles and without `[flow]` means; or a flow with inertia, from rest on",
       read_regime,
       [](const Case& c) {
         return toml_string(regime_names[static_cast<std::size_t>(c.flow.regime)]);
       }},
      {"flow.steady", "true or false",
       "creeping flow always is; `navier-stokes`: find the steady flow without its history; "
       "`run.end_time` is not used then",
       read_steady,
       [](const Case& c) { return !is_inertial(c) || c.inertia.steady ? "true" : "false"; }},
      {"flow.periodic", "list of axes, e.g. `[\"x\", \"y\"]`", "axes along which the box repeats",
       [](Case& c, const Node& node) { c.flow.periodic = read_axes(node); },
       [](const Case& c) { return write_axes(c.flow.periodic); }},
      {"flow.pressure_gradient", "pressure gradient, e.g. `\"1 kPa/m\"`, or a list of three",
       "periodic drive: the fluid is pushed towards +gradient; one value acts along the first "
       "periodic axis",
       read_gradient, write_gradient, "none"}};
  for (const auto& opening :
       {opening_keys("inlet", &Flow::inlet), opening_keys("outlet", &Flow::outlet)}) {
    keys.insert(keys.end(), opening.begin(), opening.end());
  }
  keys.push_back(faces_key("flow.walls", &Flow::walls,
                           "no-slip faces; a face that is named nowhere is one too"));
  keys.push_back(faces_key("flow.slip", &Flow::slip, "faces without friction: planes of symmetry"));
  keys.push_back({"flow.sides", "`{ faces = [\"y-\", \"y+\"], kind = \"slip\" }`",
                  "another way to say slip, or walls with `kind = \"wall\"`", read_sides,
                  [](const Case&) { return ""; }, "see walls, slip"});
  keys.push_back(quantity_key(
      "flow.reservoir", &Case::flow, &Flow::reservoir, kind::length, not_negative, "automatic",
      "open fluid before and after the sample, not part of the measurement"));
  keys.push_back(flag_key("flow.tensor", &Case::flow, &Flow::tensor,
                          "the full permeability tensor: drives each periodic axis in turn"));
  keys.push_back(quantity_key("flow.pressure_tolerance", &Case::flow, &Flow::tolerance,
                              kind::number, tolerances, "", "relative residual of the solve"));
  Key alias = quantity_key("flow.tolerance", &Case::flow, &Flow::tolerance, kind::number,
                           tolerances, "see pressure_tolerance", "short for pressure_tolerance");
  alias.write = [](const Case&) { return ""; };
  keys.push_back(alias);
  keys.push_back(integer_key("flow.max_cycles", &Case::flow, &Flow::max_cycles, Range{1, 100000},
                             "the run stops when the solve needs more"));
  keys.push_back(quantity_key("flow.max_pressure", &Case::flow, &Flow::max_pressure, kind::pressure,
                              above_zero, "no limit",
                              "drop at which a run with a given flow rate ends: the pump's limit"));
  for (const Key& key : inertia_keys()) {
    keys.push_back(key);
  }
  keys.push_back(
      choice_key("coupling.method", &Case::coupling, &Coupling::method, {"implicit", "explicit"},
                 "fluid and rigid particles in one solve; `explicit`, to compare: a step of the "
                 "fluid as if there were no particles, then what lies in each is made rigid. Its "
                 "error grows with the step (theory-coupling.md): lower travel"));
  keys.push_back(quantity_key("coupling.tolerance", &Case::coupling, &Coupling::tolerance,
                              kind::number, Range{1e-9, 1e-2}, "",
                              "relative residual of the solves after the first"));
  keys.push_back(quantity_key("coupling.travel", &Case::coupling, &Coupling::travel, kind::number,
                              Range{1e-3, 1}, "",
                              "cells that the fastest particle may move in a step"));
  keys.push_back(quantity_key("coupling.roughness", &Case::coupling, &Coupling::roughness,
                              kind::length, above_zero, "a hundredth of the smaller radius",
                              "smallest gap that lubrication knows, the height of asperities"));
  return keys;
}

Key drive_key() {
  constexpr Range factors{-1e6, 1e6};
  return list_key<DriveChange>(
      "drive", &Case::drive,
      {quantity_item("from", &DriveChange::from, kind::time, not_negative, "required",
                     "the first solve at this time or after it"),
       quantity_item("factor", &DriveChange::factor, kind::number, factors, "",
                     "on the pressures, rate or gradient that [flow] says; below 0: backwards")},
      "Changes of what drives a creeping flow with particles; a restart may say them anew");
}

std::vector<Key> clogging_keys() {
  constexpr auto part = &Case::clogging;
  using C = Clogging;
  return {
      quantity_key("clogging.stop_share", part, &C::stop_share, kind::number, Range{1e-6, 0.5}, "",
                   "of the mean speed in the pores: a slower fine rests"),
      quantity_key("clogging.hold_time", part, &C::hold_time, kind::time, above_zero,
                   "what the fluid needs for five diameters",
                   "a fine that rests so long and touches something is retained"),
      quantity_key("clogging.release_travel", part, &C::release_travel, kind::number,
                   Range{0.01, 100}, "", "diameters after which a retained fine is free again"),
      quantity_key("clogging.contact_gap", part, &C::contact_gap, kind::number, Range{0, 1}, "",
                   "diameters of the smaller one up to which two things touch"),
      quantity_key("clogging.reach", part, &C::reach, kind::number, Range{0, 100}, "",
                   "diameters beyond a throat's ends that still belong to it"),
      quantity_key("clogging.sieve_share", part, &C::sieve_share, kind::number, Range{0.5, 1.5}, "",
                   "of a throat's width: one larger fine alone is sieved there"),
      integer_key("clogging.profile_bins", part, &C::profile_bins, Range{1, 100000},
                  "bins of retention.csv along the flow"),
  };
}

}  // namespace porefines::config
