// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "dem/material.hpp"

namespace porefines::dem {

/// Factor <= 1 on Young's modulus with which a sphere pressed onto a twin by `force` [N] overlaps by
/// the share `overlap` of its diameter: F = 4/3 E sqrt(r/2) (2 r overlap)^(3/2). 1 when it is softer
/// already. The largest overlap of a run is System::largest_overlap().
[[nodiscard]] Real softening_for_force(const PairMaterial& pair, Real radius, Real force,
                                       Real overlap);

/// The same for an impact of twins at a closing speed [m/s]: d = (15 m v^2 / (16 E sqrt(R)))^(2/5).
[[nodiscard]] Real softening_for_speed(const PairMaterial& pair, Real radius, Real mass, Real speed,
                                       Real overlap);

/// Stokes number of a particle: its relaxation time 2 rho r^2 / (9 mu) over the flow's time r/U.
/// Below about 0.1 the overdamped integrator is the right one, above it Newton-Euler.
[[nodiscard]] Real stokes_number(Real density, Real radius, Real speed, Real viscosity);

}  // namespace porefines::dem
