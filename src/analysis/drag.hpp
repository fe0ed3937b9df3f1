// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <numbers>

#include "core/types.hpp"

namespace porefines::analysis {

/// Mean drag on each of n fixed bodies in a periodic box, from the balance of momentum.
///
///     F = G V / n
///
/// G [Pa/m] is the mean pressure gradient and V [m^3] the whole box: the force on the fluid, G
/// times its volume, and the push of the mean gradient on the bodies themselves, G times theirs.
/// Holds where nothing else takes up force: periodic and slip faces only.
/// Test: cli/permeability (Zick & Homsy 1982).
[[nodiscard]] inline Real mean_drag(Real gradient, Real volume, Index bodies) {
  return gradient * volume / static_cast<Real>(bodies);
}

/// Drag factor of equal spheres, K = F / (6 pi mu a U), U superficial; 1 when infinitely dilute.
/// Zick & Homsy, J. Fluid Mech. 115 (1982) 13-26.
[[nodiscard]] inline Real sphere_drag_factor(Real drag, Real viscosity, Real radius,
                                             Real superficial_velocity) {
  return drag / (6 * std::numbers::pi * viscosity * radius * superficial_velocity);
}

/// Drag of cylinders across the flow per length, F / (mu U depth).
/// Sangani & Acrivos, Int. J. Multiphase Flow 8 (1982) 193-206.
[[nodiscard]] inline Real cylinder_drag_factor(Real drag, Real viscosity, Real depth,
                                               Real superficial_velocity) {
  return drag / (viscosity * depth * superficial_velocity);
}

}  // namespace porefines::analysis
