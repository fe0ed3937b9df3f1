// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "core/types.hpp"

namespace porefines::analysis {

/// What a core-flood measurement needs, in SI.
struct DarcyFlow {
  Real flow_rate;      ///< [m^3/s]  Q through the sample
  Real area;           ///< [m^2]    A, whole cross-section, grains included
  Real length;         ///< [m]      L between the pressure planes
  Real pressure_drop;  ///< [Pa]     p_in - p_out
  Real viscosity;      ///< [Pa s]
};

/// Permeability of the sample by Darcy's law.
///
///     k = mu (Q/A) L / (p_in - p_out)
///
/// @return  [m^2]  1 darcy = 9.869233e-13 m^2
///
/// Q/A is the superficial velocity: the mean over grains *and* pores. The mean over pores
/// alone would overstate k by 1/porosity. A periodic box under the mean gradient G has the drop
/// G L. Thesis eq. (18) prints the gradient where the drop belongs; the drop is meant, since L
/// appears in the numerator.
/// Meaningful only while inertia is absent: Re = rho u d / mu < 1 (checked by the caller,
/// which reports Re beside k).
/// Tests: unit/permeability, cli/permeability (plane channel, k = h^2/12).
[[nodiscard]] inline Real darcy_permeability(const DarcyFlow& flow) {
  return flow.viscosity * (flow.flow_rate / flow.area) * flow.length / flow.pressure_drop;
}

/// Diameter of the tubes of a bundle with the same porosity and permeability.
///
///     k = porosity d^2 / 32
///
/// A length scale that every sample has, for the Reynolds number. [m]
[[nodiscard]] inline Real equivalent_pore_diameter(Real permeability, Real porosity) {
  return std::sqrt(32 * permeability / porosity);
}

}  // namespace porefines::analysis
