// SPDX-License-Identifier: MPL-2.0
// [[axis]] of a study file.
#include "study/read_axis.hpp"

#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "config/value.hpp"
#include "core/error.hpp"
#include "core/units.hpp"

namespace porefines::study {
namespace {

using config::Node;

/// A number and the text after it: "4 um" is 4 and " um".
struct Written {
  Real number = 0;
  std::string unit;
};

std::string as_setting(const Node& node) {
  if (const auto* text = std::get_if<std::string>(&node.value)) {
    return *text;
  }
  if (std::holds_alternative<config::Table>(node.value) ||
      std::holds_alternative<config::List>(node.value)) {
    config::fail(node.place, "holds a table or a list where a value is wanted",
                 "one value per key: values = [\"1 um\", \"2 um\"], or with keys = [a, b] "
                 "values = [[\"1 um\", 3], [\"2 um\", 5]]");
  }
  return config::describe(node);
}

std::string unit_of(const Dimension& dimension) {
  for (const QuantityKind& known :
       {kind::length, kind::time, kind::velocity, kind::pressure, kind::flow_rate, kind::density,
        kind::viscosity, kind::concentration, kind::pressure_gradient}) {
    if (known.dimension == dimension) {
      return std::string(known.si_unit);
    }
  }
  return {};
}

/// Where a value lies in plots, if it is a number with or without a unit.
bool place_value(const std::string& text, Real& at, std::string& unit) {
  try {
    const Quantity quantity = parse_quantity(text);
    at = quantity.value;
    unit = unit_of(quantity.dimension);
    return true;
  } catch (const InputError&) {
    return false;  // a name such as "hertz"
  }
}

Written split(const Node& node) {
  const std::string text = as_setting(node);
  std::size_t end = 0;
  try {
    const Real number = std::stod(text, &end);
    return {number, text.substr(end)};
  } catch (const std::exception&) {
    config::fail_wants(node, "a number, with its unit if it has one, such as \"1 um\"");
  }
}

const Node& need(const Node& axis, const std::string& name) {
  const Node* node = config::find(axis, name);
  if (node == nullptr) {
    config::fail(axis.place, fmt::format("needs {}", name),
                 "give values = [...], or from, to and count");
  }
  return *node;
}

/// from, to, count, spacing.
void fill_range(Axis& axis, const Node& node) {
  const Written from = split(need(node, "from"));
  const Written to = split(need(node, "to"));
  const auto count = config::read_integer(need(node, "count"), {2, 1e6});
  const Node* spacing = config::find(node, "spacing");
  const bool logarithmic = spacing != nullptr && config::read_choice(*spacing, {"linear", "log"});
  if (from.unit != to.unit) {
    config::fail(need(node, "to").place, "has another unit than from",
                 "write both in the same unit");
  }
  if (logarithmic && (from.number <= 0 || to.number <= 0)) {
    config::fail(spacing->place, "\"log\" needs from and to above zero");
  }
  for (std::int64_t i = 0; i < count; ++i) {
    const Real share = static_cast<Real>(i) / static_cast<Real>(count - 1);
    const Real exact = logarithmic ? from.number * std::pow(to.number / from.number, share)
                                   : from.number + share * (to.number - from.number);
    axis.points.push_back({{fmt::format("{:.12g}{}", exact, from.unit)}, 0});
  }
}

/// values: one per point, or one list per point with as many as there are keys.
void fill_values(Axis& axis, const Node& values) {
  for (const Node& element : config::read_list(values, "values = [\"1 um\", \"2 um\"]")) {
    AxisPoint point;
    if (const auto* list = std::get_if<config::List>(&element.value);
        list != nullptr && axis.keys.size() > 1) {
      for (const Node& value : *list) {
        point.values.push_back(as_setting(value));
      }
    } else {
      point.values.push_back(as_setting(element));
    }
    if (point.values.size() != axis.keys.size()) {
      config::fail(element.place, fmt::format("an element has {} values for {} keys",
                                              point.values.size(), axis.keys.size()));
    }
    axis.points.push_back(point);
  }
}

/// Points of one label get all of their values as labels.
void tell_apart(std::vector<AxisPoint>& points) {
  std::set<std::string> labels;
  for (const AxisPoint& point : points) {
    labels.insert(point.label);
  }
  if (labels.size() < points.size()) {
    for (AxisPoint& point : points) {
      point.label = fmt::format("{}", fmt::join(point.values, " "));
    }
  }
}

/// at = [...] when given, otherwise what the first key's values are.
void place_points(Axis& axis, const Node& node) {
  const Node* at = config::find(node, "at");
  const config::List* list = at != nullptr ? &config::read_list(*at, "at = [1.5, 2]") : nullptr;
  if (list != nullptr && list->size() != axis.points.size()) {
    config::fail(at->place,
                 fmt::format("has {} places for {} values", list->size(), axis.points.size()));
  }
  for (std::size_t i = 0; i < axis.points.size(); ++i) {
    AxisPoint& point = axis.points[i];
    point.label = list != nullptr ? as_setting((*list)[i]) : point.values.front();
    if (!place_value(point.label, point.at, axis.unit)) {
      point.at = static_cast<Real>(i + 1);
    }
  }
  tell_apart(axis.points);
}

}  // namespace

Axis read_axis(const Node& node) {
  const config::Table& table = config::read_table(
      node, {"name", "key", "keys", "values", "at", "from", "to", "count", "spacing"});
  (void)table;
  Axis axis;
  axis.place = node.place;
  const Node* keys = config::find(node, "keys");
  if (keys != nullptr) {
    for (const Node& key : config::read_list(*keys, "keys = [\"a.b\", \"c.d\"]")) {
      axis.keys.push_back(config::read_text(key));
    }
  } else if (const Node* key = config::find(node, "key")) {
    axis.keys.push_back(config::read_text(*key));
  }
  if (axis.keys.empty()) {
    config::fail(node.place, "needs a key", "such as key = \"particles.0.diameter\"");
  }
  const Node* name = config::find(node, "name");
  axis.name = name != nullptr ? config::read_text(*name) : axis.keys.front();
  if (const Node* values = config::find(node, "values")) {
    fill_values(axis, *values);
  } else if (axis.keys.size() == 1) {
    fill_range(axis, node);
  } else {
    (void)need(node, "values");
  }
  if (axis.points.empty()) {
    config::fail(node.place, "has no values");
  }
  place_points(axis, node);
  return axis;
}

}  // namespace porefines::study
