// SPDX-License-Identifier: MPL-2.0
#include "core/units.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/unit_table.hpp"

namespace porefines {
namespace {

constexpr int largest_exponent = 20;  ///< more is a typing error, and would overflow
constexpr int deepest_bracket = 8;
constexpr Real ice_point = 273.15;  ///< [K]

/// Typographic signs as the ASCII that the parser knows.
constexpr std::array<std::pair<std::string_view, std::string_view>, 14> signs{{
    {"\u00b5", "u"},
    {"\u03bc", "u"},
    {"\u00b7", "*"},
    {"\u22c5", "*"},
    {"\u00d7", "*"},
    {"\u00b0", "deg"},
    {"\u2212", "-"},
    {"\u207b", "-"},
    {"\u00b9", "1"},
    {"\u00b2", "2"},
    {"\u00b3", "3"},
    {"\u00a0", " "},
    {"\u202f", " "},
    {"\u2009", " "},
}};

std::string to_ascii(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    std::size_t taken = 0;
    for (const auto& [sign, plain] : signs) {
      if (text.starts_with(sign)) {
        out += plain;
        taken = sign.size();
        break;
      }
    }
    if (taken == 0) {
      out += text.front();
      taken = 1;
    }
    text.remove_prefix(taken);
  }
  return out;
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '%';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// The one unit with a zero of its own; within a product ("J/degC") it has no meaning.
bool is_celsius(std::string_view unit) {
  const auto start = unit.find_first_not_of(" \t");
  const auto end = unit.find_last_not_of(" \t");
  return start != unit.npos && unit.substr(start, end - start + 1) == "degC";
}

/// a * b^power; exponents stay small enough not to overflow.
Quantity times(const Quantity& a, const Quantity& b, int power) {
  const auto exponent = [power](int of_a, int of_b) {
    const int sum = of_a + power * of_b;
    if (std::abs(sum) > largest_exponent) {
      throw InputError("the exponent of the unit is absurdly large");
    }
    return sum;
  };
  const Dimension& p = a.dimension;
  const Dimension& q = b.dimension;
  return {a.value * std::pow(b.value, power),
          {exponent(p.length, q.length), exponent(p.mass, q.mass), exponent(p.time, q.time),
           exponent(p.temperature, q.temperature), exponent(p.amount, q.amount),
           exponent(p.current, q.current)}};
}

/// Recursive descent over  product := factor { ('*' | '/' | nothing) factor }.
class UnitParser {
 public:
  explicit UnitParser(std::string_view text) : rest_(text) {}

  Quantity parse() {
    skip_space();
    const Quantity unit = rest_.empty() ? Quantity{1, {}} : product(0);
    if (!rest_.empty()) {
      throw InputError(fmt::format("cannot read \"{}\"", rest_));
    }
    return unit;
  }

 private:
  Quantity product(int depth) {
    Quantity result{1, {}};
    bool divided = false;
    if (take('/')) {
      divided = true;
      result = times(result, factor(depth), -1);
    } else {
      result = factor(depth);
    }
    while (skip_space(), !rest_.empty() && rest_.front() != ')') {
      if (take('/')) {
        divided = true;
        result = times(result, factor(depth), -1);
        continue;
      }
      take('*');
      if (divided) {
        throw InputError("a product after a division is ambiguous, write kg/(m s) or kg s/m");
      }
      result = times(result, factor(depth), 1);
    }
    return result;
  }

  Quantity factor(int depth) {
    skip_space();
    if (take('(')) {
      if (depth == deepest_bracket) {
        throw InputError("too many brackets");
      }
      const Quantity inside = product(depth + 1);
      if (!take(')')) {
        throw InputError("a bracket is not closed");
      }
      return times({1, {}}, inside, exponent());
    }
    if (rest_.starts_with("1/")) {
      rest_.remove_prefix(1);
      return {1, {}};
    }
    std::size_t length = 0;
    while (length < rest_.size() && is_letter(rest_[length])) {
      ++length;
    }
    if (length == 0) {
      throw InputError(rest_.empty() ? "a unit is missing at the end"
                                     : fmt::format("cannot read \"{}\"", rest_));
    }
    const std::string_view word = rest_.substr(0, length);
    rest_.remove_prefix(length);
    const auto unit = find_unit(word);
    if (!unit) {
      const std::string guess = suggest_unit(word);
      throw InputError(fmt::format("unknown unit \"{}\"{}", word,
                                   guess.empty() ? "" : fmt::format(", did you mean {}?", guess)));
    }
    return times({1, {}}, *unit, exponent());
  }

  /// "^3", "^-1", "3" or "-1" right after a unit; 1 when there is none.
  int exponent() {
    const bool caret = !rest_.empty() && rest_.front() == '^';
    std::size_t at = caret ? 1 : 0;
    const bool negative = at < rest_.size() && rest_[at] == '-';
    if (at < rest_.size() && (rest_[at] == '-' || rest_[at] == '+')) {
      ++at;
    }
    if (at >= rest_.size() || !is_digit(rest_[at])) {
      if (at > 0) {
        throw InputError("an exponent wants a whole number, as in m^3");
      }
      return 1;
    }
    int power = 0;
    for (; at < rest_.size() && is_digit(rest_[at]); ++at) {
      power = 10 * power + (rest_[at] - '0');
      if (power > largest_exponent) {
        throw InputError("the exponent of the unit is absurdly large");
      }
    }
    rest_.remove_prefix(at);
    return negative ? -power : power;
  }

  void skip_space() {
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\t')) {
      rest_.remove_prefix(1);
    }
  }

  bool take(char sign) {
    skip_space();
    if (rest_.empty() || rest_.front() != sign) {
      return false;
    }
    rest_.remove_prefix(1);
    return true;
  }

  std::string_view rest_;
};

}  // namespace

Quantity parse_quantity(std::string_view text) {
  const std::string ascii = to_ascii(text);
  const auto start = ascii.find_first_not_of(" \t");
  std::string_view rest = start == std::string::npos ? std::string_view{} : ascii;
  rest.remove_prefix(rest.empty() ? 0 : start);
  if (rest.starts_with('+')) {
    rest.remove_prefix(1);
  }
  Real number = 0;
  const auto [end, failure] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (failure == std::errc::invalid_argument) {
    throw InputError("it does not start with a number");
  }
  if (failure != std::errc{} || !std::isfinite(number)) {
    throw InputError("the number is not finite or too small");
  }
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  if (rest.starts_with(',')) {
    throw InputError("the decimal sign is a point, not a comma");
  }
  if (is_celsius(rest)) {
    return {number + ice_point, kind::temperature.dimension};
  }
  Quantity quantity = UnitParser(rest).parse();
  quantity.value *= number;
  if (!std::isfinite(quantity.value)) {
    throw InputError("the value is not finite");
  }
  return quantity;
}

Real parse_quantity(std::string_view text, const QuantityKind& wanted, std::string_view subject) {
  const auto refuse = [&](const std::string& reason) {
    throw InputError(fmt::format("{} wants {} such as \"{}\", found \"{}\"{}", subject,
                                 with_article(wanted.name), wanted.example, text, reason));
  };
  Quantity found;
  try {
    found = parse_quantity(text);
  } catch (const InputError& problem) {
    refuse(fmt::format(": {}", problem.what()));
  }
  const bool bare = found.dimension == Dimension{};
  if (found.dimension != wanted.dimension && !(bare && found.value == 0)) {
    refuse(fmt::format(" ({})", describe(found.dimension)));
  }
  return found.value;
}

}  // namespace porefines
