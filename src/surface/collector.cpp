// SPDX-License-Identifier: MPL-2.0
#include "surface/collector.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "surface/solution.hpp"

namespace porefines::surface {
namespace {

/// g and w of Happel's cell.
struct Cell {
  Real g;
  Real g5;
  Real w;
};

Cell happel_cell(Real porosity) {
  const Real g = std::cbrt(1 - porosity);
  const Real g5 = std::pow(g, 5);
  return {g, g5, 2 - 3 * g + 3 * g5 - 2 * g5 * g};
}

}  // namespace

FiltrationNumbers filtration_numbers(const Collector& c, const Suspended& p) {
  const Cell cell = happel_cell(c.porosity);
  const Real a = p.diameter / 2;
  const Real drag = p.fluid_viscosity * c.velocity;
  return {
      .shape = 2 * (1 - cell.g5) / cell.w,
      .size = p.diameter / c.diameter,
      .peclet = c.velocity * c.diameter / diffusivity(p.temperature, p.fluid_viscosity, p.diameter),
      .van_der_waals = p.hamaker / thermal_energy(p.temperature),
      .attraction = p.hamaker / (12 * std::numbers::pi * a * a * drag),
      .gravity = 2.0 / 9 * a * a * (p.density - p.fluid_density) * p.gravity / drag};
}

CollectorEfficiency tufenkji_elimelech(const FiltrationNumbers& n) {
  const Real sinking = std::max(n.gravity, 0.0);
  return {
      2.4 * std::cbrt(n.shape) * std::pow(n.size, -0.081) * std::pow(n.peclet, -0.715) *
          std::pow(n.van_der_waals, 0.052),
      0.55 * n.shape * std::pow(n.size, 1.675) * std::pow(n.attraction, 0.125),
      0.22 * std::pow(n.size, -0.24) * std::pow(sinking, 1.11) * std::pow(n.van_der_waals, 0.053)};
}

CollectorEfficiency rajagopalan_tien(const FiltrationNumbers& n) {
  const Real sinking = std::max(n.gravity, 0.0);
  return {4 * std::cbrt(n.shape) * std::pow(n.peclet, -2.0 / 3),
          n.shape * std::pow(4.0 / 3 * n.attraction, 0.125) * std::pow(n.size, 1.875),
          0.00338 * n.shape * std::pow(sinking, 1.2) * std::pow(n.size, -0.4)};
}

Real happel_interception(Real porosity, Real size) {
  const Cell cell = happel_cell(porosity);
  const Real r = 1 + size;
  return (1 / r - (3 + 2 * cell.g5) * r + (2 + 3 * cell.g5) * r * r - cell.g5 * std::pow(r, 4)) /
         cell.w;
}

Real filtration_coefficient(const Collector& collector, Real efficiency) {
  return 1.5 * (1 - collector.porosity) * efficiency / collector.diameter;
}

}  // namespace porefines::surface
