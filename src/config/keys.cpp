// SPDX-License-Identifier: MPL-2.0
#include <algorithm>

#include <fmt/format.h>

#include "config/key.hpp"

namespace porefines::config {

const std::vector<Key>& all_keys() {
  static const std::vector<Key> keys = [] {
    std::vector<Key> all;
    for (const auto& part : {run_keys(), geometry_keys(), grid_keys(), flow_keys(), clogging_keys(),
                             box_keys(), contact_keys(), later_keys()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }();
  return keys;
}

bool applies(const Key& key, const Case& subject) {
  return key.only_for.empty() || std::find(key.only_for.begin(), key.only_for.end(),
                                           subject.geometry.kind) != key.only_for.end();
}

const std::vector<std::string>& geometry_kind_names() {
  static const std::vector<std::string> names{"image", "spheres", "cylinders", "empty"};
  return names;
}

const std::vector<std::string>& face_names() {
  static const std::vector<std::string> names{"x-", "x+", "y-", "y+", "z-", "z+"};
  return names;
}

const std::vector<std::string>& axis_names() {
  static const std::vector<std::string> names{"x", "y", "z"};
  return names;
}

void read_faces(Faces& faces, const Node& node) {
  for (const Node& name : read_list(node, "[\"z-\", \"z+\"]")) {
    faces[read_choice(name, face_names())] = true;
  }
}

std::string write_faces(const Faces& faces) {
  std::string list;
  for (std::size_t face = 0; face < faces.size(); ++face) {
    if (faces[face]) {
      list += (list.empty() ? "" : ", ") + toml_string(face_names()[face]);
    }
  }
  return "[" + list + "]";
}

std::array<bool, 3> read_axes(const Node& node) {
  std::array<bool, 3> axes{};
  for (const Node& axis : read_list(node, "[\"x\", \"y\"]")) {
    axes[read_choice(axis, axis_names())] = true;
  }
  return axes;
}

std::string write_axes(const std::array<bool, 3>& axes) {
  std::string list;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (axes[axis]) {
      list += (list.empty() ? "" : ", ") + toml_string(axis_names()[axis]);
    }
  }
  return "[" + list + "]";
}

std::string write_int3(const Int3& numbers) {
  return numbers == Int3{} ? "" : fmt::format("[{}, {}, {}]", numbers[0], numbers[1], numbers[2]);
}

Key later_key(std::string path, std::string doc) {
  return {std::move(path), "", std::move(doc), nullptr, nullptr};
}

/// What later versions add. Named so that a user learns more than "unknown key".
std::vector<Key> later_keys() {
  return {
      later_key("flow.velocity_tolerance", "one tolerance covers the solve: pressure_tolerance"),
      later_key("colloid",
                "particles have contact forces and gravity, no surface forces yet; `porefines "
                "forces` shows the laws"),
      later_key("compare", "compare summary.json with your data by hand"),
  };
}

}  // namespace porefines::config
