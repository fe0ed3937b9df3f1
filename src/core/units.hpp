// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <string_view>

#include "core/types.hpp"

namespace porefines {

/// Exponents of the SI base units; all zero is a plain number. Angles are plain (radians).
struct Dimension {
  int length = 0;
  int mass = 0;
  int time = 0;
  int temperature = 0;
  int amount = 0;
  int current = 0;
  friend bool operator==(const Dimension&, const Dimension&) = default;
};

/// A number in SI and what it measures.
struct Quantity {
  Real value = 0;
  Dimension dimension;
};

/// What a key asks for: the name and an example are for the error message.
struct QuantityKind {
  std::string_view name;
  Dimension dimension;
  std::string_view si_unit;
  std::string_view example;
};

namespace kind {
inline constexpr QuantityKind number{"plain number", {}, "", "0.5"};
inline constexpr QuantityKind length{"length", {1}, "m", "5.345 um"};
inline constexpr QuantityKind area{"area", {2}, "m^2", "2.5 darcy"};
inline constexpr QuantityKind volume{"volume", {3}, "m^3", "10 uL"};
inline constexpr QuantityKind mass{"mass", {0, 1}, "kg", "1 ug"};
inline constexpr QuantityKind time{"time", {0, 0, 1}, "s", "15 min"};
inline constexpr QuantityKind frequency{"frequency", {0, 0, -1}, "Hz", "24 Hz"};
inline constexpr QuantityKind velocity{"velocity", {1, 0, -1}, "m/s", "1 mm/s"};
inline constexpr QuantityKind acceleration{"acceleration", {1, 0, -2}, "m/s^2", "9.81 m/s^2"};
inline constexpr QuantityKind flow_rate{"flow rate", {3, 0, -1}, "m^3/s", "1 uL/min"};
inline constexpr QuantityKind pressure{"pressure", {-1, 1, -2}, "Pa", "12 Pa"};
inline constexpr QuantityKind pressure_gradient{
    "pressure gradient", {-2, 1, -2}, "Pa/m", "1 kPa/m"};
inline constexpr QuantityKind density{"density", {-3, 1}, "kg/m^3", "998.2 kg/m^3"};
inline constexpr QuantityKind viscosity{"dynamic viscosity", {-1, 1, -1}, "Pa s", "1.002 mPa s"};
inline constexpr QuantityKind kinematic_viscosity{
    "kinematic viscosity", {2, 0, -1}, "m^2/s", "1.004e-6 m^2/s"};
inline constexpr QuantityKind force{"force", {1, 1, -2}, "N", "1e-12 N"};
inline constexpr QuantityKind stiffness{"stiffness", {0, 1, -2}, "N/m", "10 N/m"};
inline constexpr QuantityKind work_per_area{"work per area", {0, 1, -2}, "J/m^2", "50 mJ/m^2"};
inline constexpr QuantityKind energy{"energy", {2, 1, -2}, "J", "9e-21 J"};
inline constexpr QuantityKind voltage{"voltage", {2, 1, -3, 0, 0, -1}, "V", "-35 mV"};
inline constexpr QuantityKind temperature{"temperature", {0, 0, 0, 1}, "K", "298.15 K"};
inline constexpr QuantityKind concentration{
    "concentration", {-3, 0, 0, 0, 1}, "mol/m^3", "10 mmol/L"};
}  // namespace kind

/// Reads "number unit" into SI.
///
/// Units multiply by a space, '*' or '·' and divide by '/'; exponents are written m^3, m3 or m³.
/// Prefixes f p n u (or µ) m c d h k M G T. Temperatures also in degC (or °C), alone. A product after a division ("kg/m s") is refused as
/// ambiguous: kg/(m s) or kg s/m says which. Units are case-sensitive.
///
/// @throws InputError  no number, an unknown unit (with a suggestion), not finite
/// Tests: unit/units.
[[nodiscard]] Quantity parse_quantity(std::string_view text);

/// Reads a quantity that must be of one kind; a number without unit is accepted only where a plain
/// number is wanted, or when it is zero.
///
/// @param subject  what the message starts with, e.g. "viscosity"
/// @return         the value in SI
/// @throws InputError  `viscosity wants a dynamic viscosity such as "1.002 mPa s",
///                     found "1.002 mPa" (a pressure)`
[[nodiscard]] Real parse_quantity(std::string_view text, const QuantityKind& wanted,
                                  std::string_view subject);

/// "a pressure", "no unit", or the base units of something without a name: "kg^2 m".
[[nodiscard]] std::string describe(const Dimension& dimension);

/// "a length", "an energy".
[[nodiscard]] std::string with_article(std::string_view noun);

/// The value with its SI unit; parse_quantity gives back the same number bit for bit.
[[nodiscard]] std::string format_quantity(Real value, const QuantityKind& quantity_kind);

}  // namespace porefines
