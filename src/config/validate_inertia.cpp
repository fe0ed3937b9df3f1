// SPDX-License-Identifier: MPL-2.0
#include <cmath>
#include <tuple>

#include <fmt/format.h>

#include "config/checks.hpp"
#include "config/item_key.hpp"

namespace porefines::config {
namespace {

/// Keys that only a flow with inertia knows.
void check_other_regime(const Node& given) {
  for (const std::string path : {"flow.scheme", "flow.time_scheme", "flow.courant",
                                 "flow.time_step", "flow.disturbance", "flow.lid", "probe"}) {
    if (const Node* node = find(given, path)) {
      fail(node->place, "needs a flow with inertia", "regime = \"navier-stokes\"");
    }
  }
}

void check_lid(const Lid& lid, const Flow& flow, const Node& given) {
  const auto at = static_cast<std::size_t>(lid.face);
  const auto axis = static_cast<std::size_t>(axis_of(lid.face));
  const auto opens = [&](const std::optional<Opening>& q) { return q && q->face == lid.face; };
  if (flow.periodic[axis] || flow.slip[at] || opens(flow.inlet) || opens(flow.outlet)) {
    fail(place_of(given, "flow.lid.face"),
         fmt::format("face {} is something else already", face_names()[at]),
         "a lid is a no-slip wall that moves");
  }
  if (lid.velocity[axis] != 0) {
    fail(place_of(given, "flow.lid.velocity"), "has a component through the wall",
         "a lid moves in its own plane");
  }
  if (lid.velocity == Triple{}) {
    fail(place_of(given, "flow.lid"), "needs a velocity",
         "lid = { face = \"y+\", velocity = [\"1 m/s\", \"0 m/s\", \"0 m/s\"] }");
  }
}

void check_outputs(const Case& subject, const Node& given) {
  for (std::size_t i = 0; i < subject.output.size() && find(given, "output") != nullptr; ++i) {
    const Node& item = item_node(given, "output", i);
    const OutputKind kind = subject.output[i].kind;
    if (kind != OutputKind::fields && kind != OutputKind::pictures && kind != OutputKind::summary) {
      fail(find(item, "kind")->place, "has no meaning for this flow",
           "kinds here: fields, pictures, summary");
    }
    const Node* every = find(item, "every");
    if (subject.inertia.steady && every != nullptr && kind != OutputKind::summary) {
      fail(every->place, "has no meaning for a steady flow, which is written once");
    }
  }
}

/// What particles in such a flow do without.
void check_with_particles(const Case& subject, const Node& given) {
  const Inertia& asked = subject.inertia;
  constexpr Real most_travel = 0.5;  // faces that a sphere leaves remember one layer
  for (const auto& [path, said, why] :
       {std::tuple{"coupling.travel", subject.coupling.travel > most_travel,
                   "with inertia at most 0.5 cells a step: longer ones are wrong, not only coarse"},
        {"flow.steady", asked.steady, "particles move: take an end_time"},
        {"flow.time_scheme", asked.time_scheme == TimeScheme::midpoint,
         "spheres need \"bdf2\" or \"euler\""},
        {"flow.disturbance", asked.disturbance > 0, "particles disturb the flow themselves"},
        {"probe", !subject.probe.empty(), "series.csv is about particles there"}}) {
    if (said) {
      fail(place_of(given, path), "is not available with particles", why);
    }
  }
}

void check_without_particles(const Case& subject, const Node& given) {
  for (const auto& [path, said] :
       {std::pair{"injection", !subject.injection.empty()},
        {"surface", !subject.surface.empty()},
        {"gravity", subject.gravity != Triple{}},
        {"coupling", !(subject.coupling == Coupling{})},
        {"contact", !(subject.contact == Contact{})},
        {"clogging", !(subject.clogging == Clogging{})},
        {"run.max_pore_volumes", subject.run.max_pore_volumes > 0},
        {"run.min_permeability_ratio", subject.run.min_permeability_ratio > 0},
        {"flow.max_pressure", subject.flow.max_pressure > 0}}) {
    if (said) {
      fail(place_of(given, path), "is for particles, and there are none");
    }
  }
  check_outputs(subject, given);
}

}  // namespace

void check_inertial(const Case& subject, const Node& given) {
  if (!is_inertial(subject)) {
    check_other_regime(given);
    return;
  }
  if (is_coupled(subject)) {
    check_with_particles(subject, given);
  } else {
    check_without_particles(subject, given);
  }
  if (subject.coupling.method == CouplingMethod::projected) {
    fail(place_of(given, "coupling.method"), "\"explicit\" is for creeping flow",
         "leave it out: with inertia the implicit solve is the only one");
  }
  if (!subject.inertia.steady && !(subject.run.end_time > 0)) {
    fail(place_of(given, "run.end_time"), "is missing",
         "end_time = \"1 s\", or steady = true for the steady flow alone");
  }
  if (subject.flow.tensor) {
    fail(place_of(given, "flow.tensor"), "is for creeping flow");
  }
  for (const auto& [name, opening] :
       {std::pair{"inlet", &subject.flow.inlet}, {"outlet", &subject.flow.outlet}}) {
    if (*opening && (*opening)->kind == DriveKind::flow_rate && subject.flow.reservoir == 0 &&
        subject.geometry.kind != GeometryKind::empty) {
      fail(place_of(given, fmt::format("flow.{}.flow_rate", name)),
           "needs open fluid before the grains: it enters evenly over the face",
           "leave flow.reservoir out, or give a velocity");
    }
  }
  if (subject.inertia.lid) {
    check_lid(*subject.inertia.lid, subject.flow, given);
  }
  for (std::size_t i = 0; i < subject.probe.size(); ++i) {
    if (find(item_node(given, "probe", i), "position") == nullptr) {
      fail(item_node(given, "probe", i).place, "needs a position");
    }
  }
}

}  // namespace porefines::config
