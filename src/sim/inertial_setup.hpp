// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <memory>

#include "config/case.hpp"
#include "flow/inertial_flow.hpp"
#include "sim/domain.hpp"

namespace porefines::sim {

/// What moves the fluid of a case, and the pressure of the case [Pa] where the solver has 0.
struct InertialDrive {
  flow::Drive drive = {};
  Real offset = 0;
};
[[nodiscard]] InertialDrive inertial_drive(const config::Case& the_case);

/// Flow rates as the velocity that they have over the whole face; with inertia no flow can be scaled to a rate.
/// Test: cli/inertial.
[[nodiscard]] config::Case with_velocities(config::Case the_case, const Domain& domain);

/// [m/s] given at a face, and [Pa/m] that pushes the fluid.
struct Push {
  Real speed = 0;
  Real force = 0;
};
[[nodiscard]] Push push_of(const Domain& domain, const flow::Drive& drive);

/// [m/s] of about the flow to come: given, or what viscosity or inertia allows the force over a cell-wide
/// to box-wide length.
[[nodiscard]] Real expected_speed(const config::Case& the_case, const Domain& domain,
                                  const Push& push);

/// Time and advection schemes of a case, in units of a speed [m/s]. Collective.
[[nodiscard]] std::unique_ptr<flow::InertialFlow> make_inertial_flow(
    const config::Case& the_case, const Domain& domain, flow::StokesSolver& solver, Real speed,
    flow::InertialFlow::First first = flow::InertialFlow::First::rest);

}  // namespace porefines::sim
