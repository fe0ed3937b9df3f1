// SPDX-License-Identifier: MPL-2.0
#include "report/picture_ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

namespace porefines::report {
namespace {

bool takes_prefix(const std::string& unit) {
  static constexpr std::array<std::string_view, 10> simple{"m", "Pa", "s", "N",  "J",
                                                           "V", "W",  "g", "Hz", "mol"};
  const auto end = unit.find_first_of("/ ");
  const std::string first = unit.substr(0, end);
  return std::find(simple.begin(), simple.end(), first) != simple.end();
}

}  // namespace

DisplayUnit display_unit(Real largest, const std::string& unit) {
  static constexpr std::array<const char*, 13> prefixes{"a", "f", "p", "n", "µ", "m", "",
                                                        "k", "M", "G", "T", "P", "E"};
  if (!(largest > 0) || !std::isfinite(largest)) {
    return {1, unit};
  }
  // A hair of tolerance: 1e-6 must not become 1000 nano.
  const int thousands = static_cast<int>(std::floor(std::log10(largest) / 3 + 1e-9));
  if (thousands == 0) {
    return {1, unit};
  }
  const Real factor = std::pow(10.0, 3 * thousands);
  if (takes_prefix(unit) && thousands >= -6 && thousands <= 6) {
    return {factor, prefixes.at(thousands + 6) + unit};
  }
  const std::string power = fmt::format("10^{}", 3 * thousands);
  return {factor, unit.empty() ? power : power + " " + unit};
}

Real nice_below(Real value) {
  const Real decade = std::pow(10.0, std::floor(std::log10(value) + 1e-9));
  for (const Real step : {5.0, 2.0}) {
    if (step * decade <= value * (1 + 1e-9)) {
      return step * decade;
    }
  }
  return decade;
}

std::vector<Real> nice_ticks(Real low, Real high, int wanted) {
  std::vector<Real> ticks;
  const Real step = nice_below((high - low) / std::max(1, wanted - 1));
  if (!(step > 0) || !std::isfinite(step)) {
    return ticks;
  }
  const Real slack = 1e-6 * step;
  for (Real i = std::ceil((low - slack) / step); i * step <= high + slack; ++i) {
    ticks.push_back(i == 0 ? 0 : i * step);
  }
  return ticks;
}

std::string tick_text(Real value, Real step) {
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 12);
  return fmt::format("{:.{}f}", value, decimals);
}

}  // namespace porefines::report
