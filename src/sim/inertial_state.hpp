// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <memory>
#include <optional>

#include "config/case.hpp"
#include "flow/body_forces.hpp"
#include "geom/build.hpp"
#include "sim/domain.hpp"

namespace porefines::sim {

/// What a run with inertia remembers besides the flow: the same on every rank.
struct InertialState {
  Index steps = 0;
  Index cycles = 0;
  Index samples = 0;         ///< rows of series.csv written
  Index fields_written = 0;  ///< moments of fields.xdmf
  Real step = 0;             ///< [s] the last one
  Real courant = 0;          ///< of it
};

/// A flow with inertia in progress.
struct InertialRun {
  const config::Case& the_case;
  const geom::Sample& sample;
  const Domain& domain;
  const par::Communicator& comm;
  flow::StokesSolver& solver;
  flow::Drive drive = {};
  Real offset = 0;  ///< [Pa] pressure of the case where the solver has 0
  Real speed =
      0;  ///< [m/s] that forces are measured by: of the inlet or the lid; 0: the mean velocity
  int bodies = 0;  ///< whose forces are told apart; grains of an image, or many, are one
  std::unique_ptr<flow::InertialFlow> flow = {};
  std::unique_ptr<flow::BodyForces> forces = {};
  InertialState state = {};
};

/// Units, schemes and drive of a case; at rest. Collective.
[[nodiscard]] InertialRun make_inertial_run(const config::Case& the_case,
                                            const geom::Sample& sample, const Domain& domain,
                                            flow::StokesSolver& solver,
                                            const par::Communicator& comm);

/// [s] of the next step: the Courant number stays below its limit, steps grow by a tenth at most, and
/// the last ones come out even at the end of the run.
///
/// At rest the fluid gains a speed of force dt/rho: the first step crosses a share of a cell.
[[nodiscard]] Real choose_step(const InertialRun& run);

/// One step. @throws RunError  no convergence, or numbers that are no longer finite. Collective.
void advance(InertialRun& run, Real step);

/// Force coefficients of a body: along the flow, and along the next axis (x: y, y: z, z: x).
///
///     C = 2 F / (rho A u^2),   A = pi R^2 of a sphere, 2 R depth of a cylinder
///
/// Thesis eq. 16. NaN where there is no body of a known size, or no speed.
struct Coefficients {
  Real drag = 0;
  Real lift = 0;
};
[[nodiscard]] Coefficients coefficients(const InertialRun& run, int body, const Vec3& force,
                                        Real speed);
/// The speed of coefficients: of the inlet or lid, else the mean velocity given.
[[nodiscard]] Real reference_speed(const InertialRun& run, const Vec3& mean_velocity);

}  // namespace porefines::sim
