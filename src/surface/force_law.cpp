// SPDX-License-Identifier: MPL-2.0
#include "surface/force_law.hpp"

namespace porefines::surface {
namespace {

DoubleLayer make_layers(const Solution& solution, const Surfaces& pair) {
  const Real scale = std::numbers::pi * absolute_permittivity(solution);
  DoubleLayer layers{.kappa = 1 / debye_length(solution)};
  if (pair.model == DoubleLayerModel::superposition) {
    const Real thermal = thermal_energy(solution.temperature) / elementary_charge;
    layers.tail = 64 * scale * thermal * thermal * std::tanh(pair.zeta1 / (4 * thermal)) *
                  std::tanh(pair.zeta2 / (4 * thermal));
    return layers;
  }
  const Real sum = pair.zeta1 + pair.zeta2;
  const Real difference = pair.zeta1 - pair.zeta2;
  layers.like = scale * sum * sum;
  layers.unlike = scale * difference * difference;
  return layers;
}

}  // namespace

ForceLaw make_force_law(const Solution& solution, const Surfaces& pair) {
  constexpr Real gregory = 14;
  return {{pair.hamaker / 6, gregory / pair.wavelength},
          make_layers(solution, pair),
          {pair.hamaker * std::pow(pair.born_diameter, 6) / 1260}};
}

}  // namespace porefines::surface
