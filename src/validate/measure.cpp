// SPDX-License-Identifier: MPL-2.0
#include "validate/measure.hpp"

#include <chrono>
#include <functional>
#include <map>

#include <fmt/format.h>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/json.hpp"
#include "mobility/known.hpp"

namespace porefines::validate {
namespace {

using Write = std::function<void(const Measurement&, Json&)>;

void write_along_wall(const Measurement& m, Json& json) {
  const mobility::AlongWall found = mobility::along_wall(m.size, m.at);
  json.set("drag", found.drag);
  json.set("force", found.force);
  json.set("torque", found.torque);
  json.set("speed", found.speed);
  json.set("spin", found.spin);
}

void write_approach(const Measurement& m, Json& json) {
  const mobility::Approach found = mobility::approach(m.size, m.at, m.exact);
  json.set("factor", found.mean * m.exact);
  json.set("worst", found.worst);
}

Write one(const std::function<Real(const Measurement&)>& number) {
  return [=](const Measurement& m, Json& json) { json.set("factor", number(m)); };
}

const std::map<std::string, Write>& known() {
  static const std::map<std::string, Write> all{
      {"wall", one([](const auto& m) { return mobility::wall_factor(m.size, m.at); })},
      {"along_wall", write_along_wall},
      {"tube", one([](const auto& m) { return mobility::tube_speed(m.size, m.at); })},
      {"approach", write_approach},
      {"together", one([](const auto& m) { return mobility::together(m.size, m.at); })},
      {"intrinsic", one([](const auto& m) { return mobility::intrinsic_viscosity(m.size); })},
      {"turn", one([](const auto& m) { return mobility::turn_factor(m.size); })},
      {"shear", one([](const auto& m) { return mobility::shear_spin(m.size); })}};
  return all;
}

}  // namespace

void measure(const Measurement& asked, const std::string& folder) {
  const auto wanted = known().find(asked.what);
  if (wanted == known().end()) {
    throw InputError(fmt::format("--measure {}: there is no such measurement", asked.what));
  }
  const auto began = std::chrono::steady_clock::now();
  Json json;
  wanted->second(asked, json);
  const std::chrono::duration<Real> took = std::chrono::steady_clock::now() - began;
  json.set("wall_time_s", took.count());
  make_folder(folder);
  write_file(folder + "/summary.json", json.text());
}

}  // namespace porefines::validate
