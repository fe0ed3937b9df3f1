// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <span>

#include "core/types.hpp"

namespace porefines::analysis {

/// Layers of cells [first, past) normal to the flow that the sample fills; the rest is reservoir.
struct Window {
  int first = 0;
  int past = 0;
};

/// Largest relative variation of the volume flux through planes normal to the flow.
///
///     (max Q - min Q) / |mean Q|
///
/// Zero for an exact solution of div u = 0; NaN when nothing flows.
/// Test: unit/permeability.
[[nodiscard]] Real flux_variation(std::span<const Real> plane_fluxes);

[[nodiscard]] Real mean(std::span<const Real> values);

/// Pressure drop between the planes where the sample begins and ends [Pa].
///
/// The pressure of a plane is the mean over the fluid of the two layers that adjoin it, so that
/// reservoirs do not count. A plane on the face of the box takes the pressure given there.
///
/// @param layer_pressures  [Pa] mean fluid pressure of every layer, low side first
/// @param at_low, at_high  [Pa] at the faces of the box
/// @return  p(low plane) - p(high plane): positive drives the flow along +axis
/// Test: unit/permeability.
[[nodiscard]] Real window_pressure_drop(std::span<const Real> layer_pressures, const Window& window,
                                        Real at_low, Real at_high);

/// Pressure at a face of the box by extrapolation from its two nearest layers [Pa].
[[nodiscard]] Real face_pressure(std::span<const Real> layer_pressures, bool high);

}  // namespace porefines::analysis
