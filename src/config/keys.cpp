// SPDX-License-Identifier: MPL-2.0
#include <algorithm>

#include <fmt/format.h>

#include "config/key.hpp"

namespace porefines::config {

const std::vector<Key>& all_keys() {
  static const std::vector<Key> keys = [] {
    std::vector<Key> all;
    for (const auto& part : {run_keys(), geometry_keys(), grid_keys(), flow_keys(), later_keys()}) {
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

std::string write_int3(const Int3& numbers) {
  return numbers == Int3{} ? "" : fmt::format("[{}, {}, {}]", numbers[0], numbers[1], numbers[2]);
}

Key later_key(std::string path, std::string doc) {
  return {std::move(path), "", std::move(doc), nullptr, nullptr};
}

/// What later versions add. Named so that a user learns more than "unknown key".
std::vector<Key> later_keys() {
  return {
      later_key("run.end_time", "this version finds the steady flow, which has no end time"),
      later_key("run.max_wall", "this version finds the steady flow in one go"),
      later_key("flow.courant", "this version finds the steady flow, without time steps"),
      later_key("flow.velocity_tolerance", "one tolerance covers the solve: pressure_tolerance"),
      later_key("particles", "this version solves the flow through fixed grains"),
      later_key("injection", "this version solves the flow through fixed grains"),
      later_key("contact", "this version solves the flow through fixed grains"),
      later_key("colloid", "this version solves the flow through fixed grains"),
      later_key("coupling", "this version solves the flow through fixed grains"),
      later_key("checkpoint", "a steady solve is short enough to be repeated"),
      later_key("compare", "compare summary.json with your data by hand"),
  };
}

}  // namespace porefines::config
