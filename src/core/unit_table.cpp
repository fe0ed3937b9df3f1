// SPDX-License-Identifier: MPL-2.0
#include "core/unit_table.hpp"

#include <array>
#include <cctype>
#include <numbers>
#include <utility>

namespace porefines {
namespace {

struct Unit {
  std::string_view symbol;
  Real value;  ///< in SI
  Dimension dimension;
  bool takes_prefix;
};

constexpr std::array units{
    Unit{"m", 1, {1}, true},
    Unit{"g", 1e-3, {0, 1}, true},
    Unit{"s", 1, {0, 0, 1}, true},
    Unit{"K", 1, {0, 0, 0, 1}, true},
    Unit{"mol", 1, {0, 0, 0, 0, 1}, true},
    Unit{"A", 1, {0, 0, 0, 0, 0, 1}, true},
    Unit{"N", 1, {1, 1, -2}, true},
    Unit{"Pa", 1, {-1, 1, -2}, true},
    Unit{"J", 1, {2, 1, -2}, true},
    Unit{"W", 1, {2, 1, -3}, true},
    Unit{"V", 1, {2, 1, -3, 0, 0, -1}, true},
    Unit{"C", 1, {0, 0, 1, 0, 0, 1}, true},
    Unit{"Hz", 1, {0, 0, -1}, true},
    Unit{"L", 1e-3, {3}, true},
    Unit{"l", 1e-3, {3}, true},
    Unit{"M", 1e3, {-3, 0, 0, 0, 1}, true},  // mol/L
    Unit{"eV", 1.602176634e-19, {2, 1, -2}, true},
    Unit{"P", 0.1, {-1, 1, -1}, true},  // poise
    Unit{"bar", 1e5, {-1, 1, -2}, true},
    Unit{"darcy", darcy, {2}, true},
    Unit{"D", darcy, {2}, true},
    Unit{"atm", 101325, {-1, 1, -2}, false},
    Unit{"psi", 6894.757293168361, {-1, 1, -2}, false},
    Unit{"min", 60, {0, 0, 1}, false},
    Unit{"h", 3600, {0, 0, 1}, false},
    Unit{"day", 86400, {0, 0, 1}, false},
    Unit{"micron", 1e-6, {1}, false},
    Unit{"rad", 1, {}, false},
    Unit{"deg", std::numbers::pi / 180, {}, false},
    Unit{"degree", std::numbers::pi / 180, {}, false},
    Unit{"degrees", std::numbers::pi / 180, {}, false},
    Unit{"%", 0.01, {}, false},
};

struct Prefix {
  char letter;
  Real factor;
};
constexpr std::array prefixes{Prefix{'f', 1e-15}, Prefix{'p', 1e-12}, Prefix{'n', 1e-9},
                              Prefix{'u', 1e-6},  Prefix{'m', 1e-3},  Prefix{'c', 1e-2},
                              Prefix{'d', 1e-1},  Prefix{'h', 1e2},   Prefix{'k', 1e3},
                              Prefix{'M', 1e6},   Prefix{'G', 1e9},   Prefix{'T', 1e12}};

constexpr std::array<std::pair<std::string_view, std::string_view>, 18> long_names{{
    {"meter", "m"},
    {"metre", "m"},
    {"sec", "s"},
    {"second", "s"},
    {"seconds", "s"},
    {"minute", "min"},
    {"minutes", "min"},
    {"hour", "h"},
    {"hours", "h"},
    {"days", "day"},
    {"pascal", "Pa"},
    {"newton", "N"},
    {"liter", "L"},
    {"litre", "L"},
    {"microns", "micron"},
    {"darcies", "darcy"},
    {"celsius", "degC"},
    {"kelvin", "K"},
}};

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& letter : out) {
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return out;
}

}  // namespace

std::optional<Quantity> find_unit(std::string_view word) {
  for (const Unit& unit : units) {
    if (word == unit.symbol) {
      return Quantity{unit.value, unit.dimension};
    }
  }
  if (word == "kg") {
    return Quantity{1, {0, 1}};  // exactly, where 1e3 * 1e-3 would be luck
  }
  for (const Prefix& prefix : prefixes) {
    if (word.empty() || word.front() != prefix.letter) {
      continue;
    }
    for (const Unit& unit : units) {
      if (unit.takes_prefix && word.substr(1) == unit.symbol) {
        return Quantity{prefix.factor * unit.value, unit.dimension};
      }
    }
  }
  return std::nullopt;
}

std::string suggest_unit(std::string_view word) {
  const std::string wrong = lower(word);
  for (const auto& [name, symbol] : long_names) {
    if (wrong == name) {
      return std::string(symbol);
    }
  }
  for (const Unit& unit : units) {
    if (wrong == lower(unit.symbol)) {
      return std::string(unit.symbol);
    }
  }
  for (const Prefix& prefix : prefixes) {
    for (const Unit& unit : units) {
      std::string right = prefix.letter + std::string(unit.symbol);
      if (unit.takes_prefix && wrong == lower(right)) {
        return right;
      }
    }
  }
  return {};
}

}  // namespace porefines
