// SPDX-License-Identifier: MPL-2.0
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "config/checks.hpp"
#include "config/item_key.hpp"

namespace porefines::config {
namespace {

/// Which key claimed which face, to name both sides of a conflict.
class Claims {
 public:
  Claims(const Flow& flow, const Node& given) : flow_(flow), given_(given) {}

  void claim(BoxFace face, const std::string& key) {
    const auto at = static_cast<std::size_t>(face);
    const std::string& name = face_names()[at];
    const std::string& axis = axis_names()[static_cast<std::size_t>(axis_of(face))];
    if (flow_.periodic[static_cast<std::size_t>(axis_of(face))]) {
      fail(place_of(given_, "flow." + key),
           fmt::format("face {} belongs to the periodic axis {}", name, axis),
           fmt::format("take \"{}\" out of periodic, or {} out of {}", axis, name, key));
    }
    if (!owner_[at].empty()) {
      fail(place_of(given_, "flow." + key),
           fmt::format("face {} is already in {}", name, owner_[at]), "a face is one thing only");
    }
    owner_[at] = key;
  }

  void claim(const std::array<bool, 6>& faces, const std::string& key) {
    const bool by_sides = find(given_, "flow." + key) == nullptr;
    for (std::size_t face = 0; face < faces.size(); ++face) {
      if (faces[face]) {
        claim(static_cast<BoxFace>(face), by_sides ? "sides" : key);
      }
    }
  }

 private:
  const Flow& flow_;
  const Node& given_;
  std::array<std::string, 6> owner_;
};

/// One of pressure, flow_rate, velocity; and the face.
void check_opening(const std::string& name, const Node& given) {
  const std::string path = "flow." + name;
  std::vector<std::string> drives;
  for (const std::string drive : {"pressure", "flow_rate", "velocity"}) {
    if (find(given, fmt::format("{}.{}", path, drive)) != nullptr) {
      drives.push_back(drive);
    }
  }
  const std::string example =
      fmt::format("{} = {{ face = \"{}\", pressure = \"{}\" }}", name,
                  name == "inlet" ? "x-" : "x+", name == "inlet" ? "12 Pa" : "0 Pa");
  if (drives.empty()) {
    fail(place_of(given, path), "needs a pressure, a flow_rate or a velocity", example);
  }
  if (drives.size() > 1) {
    fail(place_of(given, path + "." + drives[1]), fmt::format("is given beside {}", drives[0]),
         "one of them follows from the other: delete one");
  }
  if (find(given, path + ".face") == nullptr) {
    fail(place_of(given, path), "needs a face", example);
  }
}

void check_openings(const Flow& flow, const Node& given) {
  if (!flow.inlet || !flow.outlet) {
    const std::string missing = flow.inlet ? "outlet" : "inlet";
    fail(place_of(given, flow.inlet ? "flow.inlet" : "flow.outlet"),
         fmt::format("there is no {}", missing), "what enters must leave: give both");
  }
  const Opening& inlet = *flow.inlet;
  const Opening& outlet = *flow.outlet;
  if (inlet.face == outlet.face) {
    fail(place_of(given, "flow.outlet.face"), "is also the face of the inlet",
         "they are usually opposite: \"x-\" and \"x+\"");
  }
  const bool inlet_pressure = inlet.kind == DriveKind::pressure;
  const bool outlet_pressure = outlet.kind == DriveKind::pressure;
  if (!inlet_pressure && !outlet_pressure) {
    fail(place_of(given, "flow.outlet"),
         "needs a pressure, since the inlet has a flow rate or a velocity",
         "outlet = { face = \"x+\", pressure = \"0 Pa\" }");
  }
  const bool same_pressure = inlet_pressure && outlet_pressure && inlet.value == outlet.value;
  const bool no_rate =
      (!inlet_pressure && inlet.value == 0) || (!outlet_pressure && outlet.value == 0);
  if (same_pressure || no_rate) {
    fail(place_of(given, "flow.inlet"),
         same_pressure ? "nothing drives the flow: inlet and outlet have the same pressure"
                       : "nothing drives the flow: its rate is zero");
  }
}

bool any(const std::array<bool, 3>& flags) {
  return std::find(flags.begin(), flags.end(), true) != flags.end();
}

}  // namespace

void check_faces(const Flow& flow, const Node& given) {
  Claims claims(flow, given);
  for (const auto& [name, opening] : {std::pair{"inlet", &flow.inlet}, {"outlet", &flow.outlet}}) {
    if (find(given, std::string("flow.") + name) != nullptr) {
      check_opening(name, given);
    }
  }
  if (flow.inlet) {
    claims.claim(flow.inlet->face, "inlet.face");
  }
  if (flow.outlet && !(flow.inlet && flow.inlet->face == flow.outlet->face)) {
    claims.claim(flow.outlet->face, "outlet.face");
  }
  claims.claim(flow.walls, "walls");
  claims.claim(flow.slip, "slip");
}

void check_drive(const Flow& flow, const Node& given) {
  const bool opened = flow.inlet || flow.outlet;
  const bool pushed = flow.pressure_gradient != std::array<Real, 3>{};
  if (find(given, "flow.tolerance") != nullptr &&
      find(given, "flow.pressure_tolerance") != nullptr) {
    fail(place_of(given, "flow.tolerance"), "is given beside pressure_tolerance",
         "they mean the same: delete one");
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (flow.pressure_gradient[axis] != 0 && !flow.periodic[axis]) {
      fail(place_of(given, "flow.pressure_gradient"),
           fmt::format("acts along {}, which is not periodic", axis_names()[axis]),
           fmt::format("add periodic = [\"{}\"], or use inlet and outlet instead",
                       axis_names()[axis]));
    }
  }
  if (opened) {
    check_openings(flow, given);
    if (pushed) {
      fail(place_of(given, "flow.pressure_gradient"), "is given beside inlet and outlet",
           "the flow is driven by one or the other: delete one");
    }
    if (flow.tensor) {
      fail(place_of(given, "flow.tensor"), "needs periodic axes, not inlet and outlet",
           "the tensor comes from driving each periodic axis in turn");
    }
    return;
  }
  if (find(given, "flow.reservoir") != nullptr) {
    fail(place_of(given, "flow.reservoir"), "has no meaning without inlet and outlet");
  }
  if (flow.tensor && !any(flow.periodic)) {
    fail(place_of(given, "flow.tensor"), "needs at least one periodic axis",
         "periodic = [\"x\", \"y\", \"z\"]");
  }
  if (!pushed && !flow.tensor) {
    fail(place_of(given, any(flow.periodic) ? "flow.pressure_gradient" : "flow.inlet"),
         "nothing drives the flow",
         "give inlet and outlet, or a pressure_gradient along a periodic axis");
  }
}

void check_drive_changes(const Case& subject, const Node& given) {
  if (subject.drive.empty()) {
    return;
  }
  if (!is_coupled(subject) || is_inertial(subject)) {
    fail(place_of(given, "drive"), "is for a creeping flow with particles",
         "without particles, and with inertia, one drive stays from the beginning to the end");
  }
  Real last = -1;
  for (std::size_t i = 0; i < subject.drive.size(); ++i) {
    const Node& item = item_node(given, "drive", i);
    const DriveChange& change = subject.drive[i];
    if (change.from < 0) {
      fail(item.place, "needs a time", "from = \"0.1 s\"");
    }
    if (change.from <= last) {
      fail(place_of(item, "from"), "is not after the one before", "list changes by rising time");
    }
    if (change.factor == 0) {
      fail(place_of(item, "factor"), "is zero: nothing would drive the flow",
           "a small factor, such as 1e-3, if it should almost stop");
    }
    last = change.from;
  }
}

}  // namespace porefines::config
