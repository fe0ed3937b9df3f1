// SPDX-License-Identifier: MPL-2.0
#include "config/value.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "core/json.hpp"
#include "core/suggest.hpp"

namespace porefines::config {
namespace {

/// `"a", "b" or "c"`.
std::string one_of(const std::vector<std::string>& known) {
  std::string text;
  for (std::size_t i = 0; i < known.size(); ++i) {
    text += i == 0 ? "" : i + 1 == known.size() ? " or " : ", ";
    text += toml_string(known[i]);
  }
  return text;
}

}  // namespace

std::string Range::text(const QuantityKind& quantity_kind) const {
  const auto show = [&](Real value) {
    return value == std::floor(value) && std::abs(value) < 1e15 && quantity_kind.si_unit.empty()
               ? fmt::format("{:.0f}", value)
               : format_quantity(value, quantity_kind);
  };
  const bool open_end = high == std::numeric_limits<Real>::max();
  if (above) {
    return open_end ? fmt::format("above {}", show(low))
                    : fmt::format("above {} and up to {}", show(low), show(high));
  }
  return open_end ? fmt::format("{} or more", show(low))
                  : fmt::format("from {} to {}", show(low), show(high));
}

void fail_wants(const Node& node, const std::string& what, const std::string& hint) {
  throw InputError(fmt::format("{} wants {}, found {}{}{}", node.place.text(), what, describe(node),
                               hint.empty() ? "" : "\n", hint));
}

std::string describe(const Node& node) {
  struct Describe {
    std::string operator()(const Table&) const { return "a table"; }
    std::string operator()(const List&) const { return "a list"; }
    std::string operator()(const std::string& text) const { return toml_string(text); }
    std::string operator()(bool flag) const { return flag ? "true" : "false"; }
    std::string operator()(std::int64_t number) const { return fmt::format("{}", number); }
    std::string operator()(double number) const { return fmt::format("{}", number); }
    std::string operator()(Date) const { return "a date or time"; }
  };
  return std::visit(Describe{}, node.value);
}

const std::string& read_text(const Node& node) {
  if (const auto* text = std::get_if<std::string>(&node.value)) {
    return *text;
  }
  fail_wants(node, "a text in quotes");
}

bool read_flag(const Node& node) {
  if (const auto* flag = std::get_if<bool>(&node.value)) {
    return *flag;
  }
  fail_wants(node, "true or false (without quotes)");
}

std::int64_t read_integer(const Node& node, const Range& range) {
  const auto* number = std::get_if<std::int64_t>(&node.value);
  if (number == nullptr || !range.contains(static_cast<Real>(*number))) {
    fail_wants(node, fmt::format("a whole number {}", range.text()));
  }
  return *number;
}

Int3 read_int3(const Node& node, const Range& range, const std::string& example) {
  const List& list = read_list(node, example);
  if (list.size() != 3) {
    fail(node.place, fmt::format("has {} numbers, needs 3: {}", list.size(), example));
  }
  Int3 numbers{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    numbers[axis] = static_cast<int>(read_integer(list[axis], range));
  }
  return numbers;
}

Real read_quantity(const Node& node, const QuantityKind& wanted, const Range& range) {
  Real value = 0;
  const bool plain = wanted.dimension == Dimension{};
  if (const auto* text = std::get_if<std::string>(&node.value)) {
    value = parse_quantity(*text, wanted, node.place.text());
  } else if (const auto* integer = std::get_if<std::int64_t>(&node.value)) {
    value = static_cast<Real>(*integer);
  } else if (const auto* real = std::get_if<double>(&node.value)) {
    value = *real;
  } else {
    fail_wants(node,
               plain ? "a number"
                     : fmt::format("{} such as \"{}\"", with_article(wanted.name), wanted.example));
  }
  if (!std::isfinite(value)) {
    fail(node.place, fmt::format("{} is not a finite number", describe(node)));
  }
  const bool bare = !std::holds_alternative<std::string>(node.value);
  if (bare && !plain && value != 0) {
    fail_wants(node, fmt::format("{} such as \"{}\"", with_article(wanted.name), wanted.example),
               fmt::format("a bare number has no unit; if SI is meant, write \"{}\"",
                           format_quantity(value, wanted)));
  }
  if (!range.contains(value)) {
    fail(node.place,
         fmt::format("{} is out of range, allowed is {}", describe(node), range.text(wanted)),
         plain ? "" : fmt::format("for example \"{}\"", wanted.example));
  }
  return value;
}

const List& read_list(const Node& node, const std::string& example) {
  if (const auto* list = std::get_if<List>(&node.value)) {
    return *list;
  }
  fail_wants(node, fmt::format("a list such as {}", example));
}

std::size_t read_choice(const Node& node, const std::vector<std::string>& known) {
  const auto* text = std::get_if<std::string>(&node.value);
  const auto found = text == nullptr ? known.end() : std::find(known.begin(), known.end(), *text);
  if (found == known.end()) {
    const std::string guess = text == nullptr ? "" : closest(*text, known);
    fail_wants(node, one_of(known),
               guess.empty() ? "" : fmt::format("did you mean \"{}\"?", guess));
  }
  return static_cast<std::size_t>(found - known.begin());
}

const Table& read_table(const Node& node, const std::vector<std::string>& known) {
  const auto* table = std::get_if<Table>(&node.value);
  if (table == nullptr) {
    fail_wants(node, fmt::format("a table with {}", fmt::join(known, ", ")));
  }
  for (const Entry& entry : *table) {
    if (std::find(known.begin(), known.end(), entry.name) == known.end()) {
      fail_unknown(entry.node.place, entry.name, known, "");
    }
  }
  return *table;
}

void fail_unknown(const Place& place, const std::string& name,
                  const std::vector<std::string>& known, const std::string& hint) {
  const std::string guess = closest(name, known);
  const char* what = place.shape == Place::Shape::key ? "key" : "table";
  if (!guess.empty()) {
    fail(place, fmt::format("unknown {}; did you mean {}?", what, guess), hint);
  }
  fail(place, fmt::format("unknown {}", what),
       hint.empty() ? fmt::format("known here: {}", fmt::join(known, ", ")) : hint);
}

std::string toml_string(const std::string& text) {
  return json_string(text);  // every JSON string is a basic TOML string
}

std::string toml_quantity(Real value, const QuantityKind& quantity_kind) {
  const std::string text = format_quantity(value, quantity_kind);
  return quantity_kind.si_unit.empty() ? text : toml_string(text);
}

}  // namespace porefines::config
