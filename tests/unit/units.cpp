// SPDX-License-Identifier: MPL-2.0
#include "core/units.hpp"

#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace porefines {
namespace {

std::string message_of(const std::string& text, const QuantityKind& wanted) {
  try {
    return "accepted: " + std::to_string(parse_quantity(text, wanted, "viscosity"));
  } catch (const InputError& error) {
    return error.what();
  }
}

struct Reading {
  const char* text;
  Real value;
  QuantityKind wanted;
};

class Units : public ::testing::TestWithParam<Reading> {};

TEST_P(Units, are_read_into_si) {
  const auto& [text, value, wanted] = GetParam();
  const Quantity found = parse_quantity(text);
  EXPECT_NEAR(found.value, value, 1e-14 * std::abs(value)) << text;
  EXPECT_EQ(found.dimension, wanted.dimension) << text << " is " << describe(found.dimension);
}

constexpr Reading readings[] = {
    {"5.345 um", 5.345e-6, kind::length},
    {"5.345 \u00b5m", 5.345e-6, kind::length},  // micro sign
    {"5.345 \u03bcm", 5.345e-6, kind::length},  // Greek mu
    {"5um", 5e-6, kind::length},
    {"  +5   um  ", 5e-6, kind::length},
    {"-3 nm", -3e-9, kind::length},
    {"\u22123 nm", -3e-9, kind::length},  // typographic minus
    {"12 Pa", 12, kind::pressure},
    {"2 mbar", 200, kind::pressure},
    {"1.5 bar", 1.5e5, kind::pressure},
    {"1 psi", 6894.757293168361, kind::pressure},
    {"1 atm", 101325, kind::pressure},
    {"30 MPa", 30e6, kind::pressure},
    {"1 N/m^2", 1, kind::pressure},
    {"1 uL/min", 1e-9 / 60, kind::flow_rate},
    {"3.6 L/h", 1e-6, kind::flow_rate},
    {"1.002 mPa s", 1.002e-3, kind::viscosity},
    {"1.002 mPa*s", 1.002e-3, kind::viscosity},
    {"1.002 mPa\u00b7s", 1.002e-3, kind::viscosity},
    {"1 cP", 1e-3, kind::viscosity},
    {"1 kg/(m s)", 1, kind::viscosity},
    {"1 kg m^-1 s^-1", 1, kind::viscosity},
    {"1 kg m-1 s-1", 1, kind::viscosity},
    {"998.2 kg/m^3", 998.2, kind::density},
    {"998.2 kg/m3", 998.2, kind::density},
    {"998.2 kg/m\u00b3", 998.2, kind::density},
    {"998.2 kg m\u207b\u00b3", 998.2, kind::density},
    {"1.05 g/cm^3", 1050, kind::density},
    {"1 Pa/m", 1, kind::pressure_gradient},
    {"2 kPa/m", 2000, kind::pressure_gradient},
    {"1e-12 N", 1e-12, kind::force},
    {"1 kg m/s/s", 1, kind::force},
    {"15 min", 900, kind::time},
    {"2 h", 7200, kind::time},
    {"10 ms", 0.01, kind::time},
    {"24 Hz", 24, kind::frequency},
    {"24 1/s", 24, kind::frequency},
    {"24 /s", 24, kind::frequency},
    {"10 mmol/L", 10, kind::concentration},
    {"10 mM", 10, kind::concentration},
    {"-35 mV", -0.035, kind::voltage},
    {"7.5e-21 J", 7.5e-21, kind::energy},
    {"298.15 K", 298.15, kind::temperature},
    {"25 degC", 298.15, kind::temperature},
    {"25 \u00b0C", 298.15, kind::temperature},
    {" -10degC ", 263.15, kind::temperature},
    {"0.1 M", 100, kind::concentration},
    {"10 mol/m^3", 10, kind::concentration},
    {"50 mJ/m^2", 0.05, kind::work_per_area},
    {"50 mN/m", 0.05, kind::work_per_area},
    {"180 degrees", std::numbers::pi, kind::number},
    {"180\u00b0", std::numbers::pi, kind::number},
    {"5 %", 0.05, kind::number},
    {"2.5 darcy", 2.5 * 9.869233e-13, kind::area},
    {"10 mD", 9.869233e-15, kind::area},
};
INSTANTIATE_TEST_SUITE_P(All, Units, ::testing::ValuesIn(readings));

TEST(UnitErrors, name_what_is_wanted_and_what_was_found) {
  EXPECT_EQ(message_of("1.002 mPa", kind::viscosity),
            "viscosity wants a dynamic viscosity such as \"1.002 mPa s\", found \"1.002 mPa\" "
            "(a pressure)");
  EXPECT_EQ(message_of("1.002", kind::viscosity),
            "viscosity wants a dynamic viscosity such as \"1.002 mPa s\", found \"1.002\" "
            "(no unit)");
}

TEST(UnitErrors, a_dimension_without_a_name_is_shown_in_base_units) {
  EXPECT_EQ(describe(Dimension{2, 1}), "kg m^2");
}

TEST(UnitErrors, explain_what_could_not_be_read) {
  const auto ends_with = [](const std::string& text, const std::string& end) {
    const std::string message = message_of(text, kind::length);
    EXPECT_TRUE(message.ends_with(end)) << message;
  };
  ends_with("5 umm", ": unknown unit \"umm\"");
  ends_with("5 UM", ": unknown unit \"UM\", did you mean um?");
  ends_with("5 metre", ": unknown unit \"metre\", did you mean m?");
  ends_with("um", ": it does not start with a number");
  ends_with("", ": it does not start with a number");
  ends_with("5,3 um", ": the decimal sign is a point, not a comma");
  ends_with("nan m", ": the number is not finite or too small");
  ends_with("inf m", ": the number is not finite or too small");
  ends_with("1e999 m", ": the number is not finite or too small");
  ends_with("1e308 km", ": the value is not finite");
  ends_with("1 kg/m s", ": a product after a division is ambiguous, write kg/(m s) or kg s/m");
  ends_with("1 kg/(m s", ": a bracket is not closed");
  ends_with("1 m)", ": cannot read \")\"");
  ends_with("1 m^", ": an exponent wants a whole number, as in m^3");
  ends_with("1 m^999", ": the exponent of the unit is absurdly large");
  ends_with("1 m^20 m^20", ": the exponent of the unit is absurdly large");
  ends_with("1 m/", ": a unit is missing at the end");
  ends_with("1 " + std::string(100, '('), ": too many brackets");
}

TEST(UnitErrors, of_temperatures_concentrations_and_voltages) {
  EXPECT_EQ(message_of("25 C", kind::temperature),
            "viscosity wants a temperature such as \"298.15 K\", found \"25 C\" (s A)");
  EXPECT_EQ(
      message_of("25 celsius", kind::temperature),
      "viscosity wants a temperature such as \"298.15 K\", found \"25 celsius\": unknown unit "
      "\"celsius\", did you mean degC?");
  EXPECT_TRUE(message_of("1 J/degC", kind::energy).ends_with("unknown unit \"degC\""));
  EXPECT_EQ(message_of("10 mm", kind::concentration),
            "viscosity wants a concentration such as \"10 mmol/L\", found \"10 mm\" (a length)");
  EXPECT_EQ(message_of("40 mW", kind::voltage),
            "viscosity wants a voltage such as \"-35 mV\", found \"40 mW\" (kg m^2 s^-3)");
  EXPECT_EQ(message_of("50 mJ", kind::work_per_area),
            "viscosity wants a work per area such as \"50 mJ/m^2\", found \"50 mJ\" (an energy)");
}

TEST(UnitErrors, zero_needs_no_unit) {
  EXPECT_EQ(parse_quantity("0", kind::pressure, "p"), 0);
  EXPECT_THROW((void)parse_quantity("0 m", kind::pressure, "p"), InputError);
}

TEST(FormatQuantity, reads_back_the_same_bits) {
  for (const QuantityKind& wanted :
       {kind::length, kind::viscosity, kind::density, kind::flow_rate, kind::concentration,
        kind::number, kind::voltage, kind::pressure_gradient, kind::work_per_area,
        kind::temperature}) {
    for (const Real value : {0.1, 1.0 / 3, 5.345e-6, 998.2, 1e300, -2.0}) {
      const std::string text = format_quantity(value, wanted);
      EXPECT_EQ(parse_quantity(text, wanted, "it"), value) << text;
    }
  }
}

}  // namespace
}  // namespace porefines
