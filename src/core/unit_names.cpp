// SPDX-License-Identifier: MPL-2.0
// How quantities are written for a person.
#include <array>

#include <fmt/format.h>

#include "core/units.hpp"

namespace porefines {
namespace {

constexpr std::array known_kinds{
    kind::length,        kind::area,         kind::volume,
    kind::mass,          kind::time,         kind::frequency,
    kind::velocity,      kind::acceleration, kind::flow_rate,
    kind::pressure,      kind::density,      kind::pressure_gradient,
    kind::viscosity,     kind::force,        kind::kinematic_viscosity,
    kind::energy,        kind::voltage,      kind::temperature,
    kind::concentration, kind::stiffness,
};

}  // namespace

std::string with_article(std::string_view noun) {
  const bool vowel = !noun.empty() && std::string_view("aeio").find(noun[0]) != noun.npos;
  return fmt::format("{} {}", vowel ? "an" : "a", noun);
}

std::string describe(const Dimension& dimension) {
  if (dimension == Dimension{}) {
    return "no unit";
  }
  for (const QuantityKind& known : known_kinds) {
    if (known.dimension == dimension) {
      return with_article(known.name);
    }
  }
  const std::array<std::pair<std::string_view, int>, 6> bases{{{"kg", dimension.mass},
                                                               {"m", dimension.length},
                                                               {"s", dimension.time},
                                                               {"K", dimension.temperature},
                                                               {"mol", dimension.amount},
                                                               {"A", dimension.current}}};
  std::string text;
  for (const auto& [symbol, power] : bases) {
    if (power != 0) {
      text += fmt::format("{}{}{}", text.empty() ? "" : " ", symbol,
                          power == 1 ? "" : fmt::format("^{}", power));
    }
  }
  return text;
}

std::string format_quantity(Real value, const QuantityKind& quantity_kind) {
  return quantity_kind.si_unit.empty() ? fmt::format("{}", value)
                                       : fmt::format("{} {}", value, quantity_kind.si_unit);
}

}  // namespace porefines
