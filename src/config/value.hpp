// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "config/tree.hpp"
#include "core/types.hpp"
#include "core/units.hpp"

/// Reads single values from the tree; every function throws an InputError that says what the key
/// wants and what was found.
namespace porefines::config {

/// What a number may be, ends included unless `above` is set. NaN is in no range.
struct Range {
  Real low = -std::numeric_limits<Real>::max();
  Real high = std::numeric_limits<Real>::max();
  bool above = false;  ///< low itself is excluded

  [[nodiscard]] bool contains(Real value) const {
    return (above ? value > low : value >= low) && value <= high;
  }
  /// "above 0 m", "from 1e-06 Pa s to 1000 Pa s", "0 or more".
  [[nodiscard]] std::string text(const QuantityKind& quantity_kind = kind::number) const;
};
inline constexpr Range any_number{};
inline constexpr Range not_negative{0};
inline constexpr Range above_zero{0, std::numeric_limits<Real>::max(), true};

/// @throws InputError  "<place> wants <what>, found <node>"
[[noreturn]] void fail_wants(const Node& node, const std::string& what,
                             const std::string& hint = "");

[[nodiscard]] std::string describe(const Node& node);
[[nodiscard]] const std::string& read_text(const Node& node);
[[nodiscard]] bool read_flag(const Node& node);
[[nodiscard]] std::int64_t read_integer(const Node& node, const Range& range);
[[nodiscard]] Int3 read_int3(const Node& node, const Range& range, const std::string& example);
/// Also plain numbers, with kind::number.
[[nodiscard]] Real read_quantity(const Node& node, const QuantityKind& wanted, const Range& range);
/// @param example  for the message: what such a list looks like
[[nodiscard]] const List& read_list(const Node& node, const std::string& example);
/// The index of the word in `known`.
[[nodiscard]] std::size_t read_choice(const Node& node, const std::vector<std::string>& known);
/// Fails on an entry that is not in `known`.
[[nodiscard]] const Table& read_table(const Node& node, const std::vector<std::string>& known);
[[noreturn]] void fail_unknown(const Place& place, const std::string& name,
                               const std::vector<std::string>& known, const std::string& hint);

/// A TOML string with its quotes.
[[nodiscard]] std::string toml_string(const std::string& text);
/// `"5.345e-06 m"`, or the bare number for kind::number.
[[nodiscard]] std::string toml_quantity(Real value, const QuantityKind& quantity_kind);

}  // namespace porefines::config
