// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "config/case.hpp"
#include "config/value.hpp"

namespace porefines::config {

/// A line of the reference page about a key of a table that may repeat.
struct ItemLine {
  std::string name;
  std::string type;
  std::string value;  ///< the default, or what leaving it out means
  std::string doc;
};

/// One key of the case file. The list of them (all_keys) is all there is to know about the format:
/// reading, unknown-key errors, the effective case and the reference page follow from it.
struct Key {
  std::string path;                               ///< "grid.cell_size"
  std::string type;                               ///< for people: `length, e.g. "5.345 um"`
  std::string doc;                                ///< one line
  std::function<void(Case&, const Node&)> read;   ///< empty: not available in this version
  std::function<std::string(const Case&)> write;  ///< the TOML value; "" when absent
  std::string absent = "";                        ///< what leaving it out means, when write says ""
  std::vector<GeometryKind> only_for = {};        ///< empty: every kind of geometry
  std::vector<ItemLine> items = {};               ///< of a table that may repeat
};

/// Every key, in the order in which they are read and written.
[[nodiscard]] const std::vector<Key>& all_keys();

/// The parts of all_keys().
[[nodiscard]] std::vector<Key> run_keys();
[[nodiscard]] Key particles_key();
[[nodiscard]] Key injection_key();
[[nodiscard]] Key surface_key();
[[nodiscard]] std::vector<Key> contact_keys();
[[nodiscard]] std::vector<Key> box_keys();
[[nodiscard]] std::vector<Key> geometry_keys();
[[nodiscard]] std::vector<Key> grid_keys();
[[nodiscard]] std::vector<Key> flow_keys();
[[nodiscard]] std::vector<Key> clogging_keys();
[[nodiscard]] std::vector<Key> inertia_keys();
[[nodiscard]] Key drive_key();
[[nodiscard]] Key probe_key();
[[nodiscard]] std::vector<Key> later_keys();

/// Whether the key has a meaning for the geometry of this case.
[[nodiscard]] bool applies(const Key& key, const Case& subject);

[[nodiscard]] const std::vector<std::string>& geometry_kind_names();  ///< indexed by GeometryKind
[[nodiscard]] const std::vector<std::string>& face_names();           ///< indexed by BoxFace
[[nodiscard]] const std::vector<std::string>& axis_names();

using Faces = std::array<bool, 6>;  ///< indexed by BoxFace
/// Sets those that are named.
void read_faces(Faces& faces, const Node& node);
[[nodiscard]] std::string write_faces(const Faces& faces);
[[nodiscard]] std::array<bool, 3> read_axes(const Node& node);
[[nodiscard]] std::string write_axes(const std::array<bool, 3>& axes);

/// "[64, 64, 64]", or "" for three zeros.
[[nodiscard]] std::string write_int3(const Int3& numbers);

// How the common kinds of keys are made. `part` and `member` lead to the variable in the Case.

template <typename Part>
Key text_key(const std::string& path, Part Case::*part, std::string Part::*member,
             const std::string& absent, const std::string& doc) {
  return {path,
          "text",
          doc,
          [=](Case& c, const Node& node) { c.*part.*member = read_text(node); },
          [=](const Case& c) {
            const std::string& text = c.*part.*member;
            return text.empty() ? "" : toml_string(text);
          },
          absent};
}

template <typename Part>
Key flag_key(const std::string& path, Part Case::*part, bool Part::*member,
             const std::string& doc) {
  return {path, "true or false", doc,
          [=](Case& c, const Node& node) { c.*part.*member = read_flag(node); },
          [=](const Case& c) { return std::string(c.*part.*member ? "true" : "false"); }};
}

/// Integers stay below 2^63, the largest that TOML can say.
template <typename Part, typename Integer>
Key integer_key(const std::string& path, Part Case::*part, Integer Part::*member, Range range,
                const std::string& doc) {
  return {path, "whole number, " + range.text(), doc,
          [=](Case& c, const Node& node) {
            c.*part.*member = static_cast<Integer>(read_integer(node, range));
          },
          [=](const Case& c) { return std::to_string(c.*part.*member); }};
}

/// A quantity, or with kind::number a plain number. A value outside of its range means absent.
template <typename Part>
Key quantity_key(const std::string& path, Part Case::*part, Real Part::*member,
                 const QuantityKind& wanted, Range range, const std::string& absent,
                 const std::string& doc) {
  const std::string type = wanted.si_unit.empty() ? "number, " + range.text()
                                                  : std::string(wanted.name) + ", e.g. `\"" +
                                                        std::string(wanted.example) + "\"`";
  return {path,
          type,
          doc,
          [=](Case& c, const Node& node) { c.*part.*member = read_quantity(node, wanted, range); },
          [=](const Case& c) {
            const Real value = c.*part.*member;
            return range.contains(value) ? toml_quantity(value, wanted) : std::string();
          },
          absent};
}

/// A word out of a list whose order is that of the enum.
template <typename Part, typename Enum>
Key choice_key(const std::string& path, Part Case::*part, Enum Part::*member,
               const std::vector<std::string>& names, const std::string& doc) {
  std::string type;
  for (const std::string& name : names) {
    type += (type.empty() ? "`" : ", `") + toml_string(name) + "`";
  }
  return {
      path, type, doc,
      [=](Case& c, const Node& node) {
        c.*part.*member = static_cast<Enum>(read_choice(node, names));
      },
      [=](const Case& c) { return toml_string(names[static_cast<std::size_t>(c.*part.*member)]); }};
}

/// Three whole numbers; all zero means absent.
template <typename Part>
Key int3_key(const std::string& path, Part Case::*part, Int3 Part::*member, Range range,
             const std::string& example, const std::string& absent, const std::string& doc) {
  return {path,
          "three whole numbers, e.g. `" + example + "`",
          doc,
          [=](Case& c, const Node& node) { c.*part.*member = read_int3(node, range, example); },
          [=](const Case& c) { return write_int3(c.*part.*member); },
          absent};
}

[[nodiscard]] Key later_key(std::string path, std::string doc);

}  // namespace porefines::config
