// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "analysis/readings.hpp"
#include "config/case.hpp"
#include "flow/inertial_flow.hpp"
#include "flow/rigid_projection.hpp"
#include "sim/domain.hpp"
#include "sim/dry_state.hpp"
#include "sim/steady_flow.hpp"

namespace porefines::sim {

/// What the last solve says about the flow.
struct FlowNow {
  DarcyFlow darcy = {};
  int cycles = 0;  ///< of all solves of the step
  Real residual = 0;
};

/// What a coupled run remembers besides particles and fields: the same on every rank, but for the
/// readings.
struct CoupledState {
  Real clean_permeability = 0;  ///< [m^2] k0, before any particle
  Real clean_rate = 0;          ///< [m^3/s]
  Real drive_factor = 1;        ///< on the drive of the case: a pump turns it up
  Real fluid_passed = 0;        ///< [m^3] through the sample so far
  Real volume_in = 0;           ///< [m^3] of particles injected
  Real volume_out = 0;          ///< [m^3] of particles gone
  Index solves = 0;
  Index cycles = 0;
  Index substeps = 0;
  Real stiffness = 1;                    ///< factor on all moduli, see soften()
  Index stiffened = 0;                   ///< how often it was raised
  Real deepest = 0;                      ///< [radii] overlap for which it was raised last
  Index clogged_throats = 0;             ///< at the last sample
  analysis::ReadingState readings = {};  ///< rank 0
};

/// Fluid and particles in progress. Particles live in the whole grid's box, reservoirs included, in
/// coordinates whose zero is the corner of the sample.
struct CoupledRun {
  const config::Case& the_case;  ///< with [box] as the flow makes it
  const Domain& domain;
  flow::StokesSolver& solver;
  DryRun particles;
  flow::Drive drive;     ///< at drive_factor 1
  Real wanted_rate = 0;  ///< [m^3/s] of a pump; 0: pressures are given
  Real offset = 0;       ///< [Pa] on the pressures that the solver holds
  Real pore_volume = 0;  ///< [m^3] of the sample
  FlowNow now;
  CoupledState state;
  bool cold = true;  ///< nothing is known of the flow with particles yet
  /// With regime = "navier-stokes"; or the fluid's part of the explicit coupling.
  std::unique_ptr<flow::InertialFlow> inertial = {};
  std::unique_ptr<flow::RigidProjection> projection = {};  ///< with coupling.method = "explicit"

  [[nodiscard]] const par::Communicator& comm() const { return particles.comm; }
  [[nodiscard]] Real time() const { return particles.state.time; }
  /// Of [[drive]]: what drives the case times this drives it at a time.
  [[nodiscard]] Real drive_at(Real moment) const;
  [[nodiscard]] Real drive_now() const { return drive_at(time()); }
  [[nodiscard]] Real pore_volumes() const { return state.fluid_passed / pore_volume; }
  /// NaN where nothing drives the fluid.
  [[nodiscard]] Real permeability_ratio() const {
    return state.clean_permeability > 0 ? now.darcy.permeability / state.clean_permeability
                                        : std::numeric_limits<Real>::quiet_NaN();
  }
};

/// Does anything but particles and lids move the fluid?
[[nodiscard]] inline bool is_driven(const config::Flow& flow) {
  return flow.inlet || flow.pressure_gradient != config::Triple{};
}

/// The case with the faces of [box] as the flow has them: openings let particles out, slip faces are
/// smooth walls, the others rough ones.
[[nodiscard]] config::Case with_box_of_flow(config::Case the_case);

/// Velocities of openings as rates through the whole face where config::pumps_velocities, else the case as it is.
[[nodiscard]] config::Case with_rates(config::Case the_case, const Domain& domain);

/// Box, walls and inlets, no particles yet; `clean` is the flow without them. Collective.
/// @throws InputError  anything wrong with them
[[nodiscard]] CoupledRun make_coupled_run(const config::Case& the_case, const geom::Sample& sample,
                                          const Domain& domain, const par::Decomposition& cut,
                                          flow::StokesSolver& solver, const SteadyFlow& clean,
                                          Real porosity, const par::Communicator& comm);

// The sentences of the loop; all collective.

/// Fluid and particles where they are now: motions U* of the particles, fluxes, permeability.
/// A pump's drive is turned until its rate flows, to 0.1 %.
/// @throws RunError  the solve broke down or did not converge
void solve_flow(CoupledRun& run);

/// [s] until the fastest particle, or what is about to enter, has moved coupling.travel cells, or
/// the next sample is due.
[[nodiscard]] Real choose_step(const CoupledRun& run);

/// Moves the particles with the flow and against each other, overdamped (System::creep).
/// @return [s] less than `step` where something was let go and has gone half as far again as a step allows
Real move_particles(CoupledRun& run, Real step);

/// Tolerance and cycles of a step of the fluid with inertia, or of the explicit coupling.
[[nodiscard]] flow::StepOptions step_options(const config::Case& the_case);

/// Counts a solve of this step.
void count_solve(CoupledRun& run, int cycles, Real residual);

/// Grains and walls within a cell or so of the spheres of this rank.
[[nodiscard]] std::vector<flow::WallGap> walls_near(const CoupledRun& run);

/// Contacts become twice as stiff or more when an overlap has come near its bound: an arch presses harder
/// than the lone fine that the run begins with in mind, a wedged fine harder still.
void stiffen_contacts(CoupledRun& run);

/// @throws RunError  overlaps beyond their bound, and contacts as stiff as can be; or ten times the bound
void require_bearable(const CoupledRun& run);

/// What left through openings, and what became due at the inlets.
/// @return rows of those that left, for tracks.csv
[[nodiscard]] std::string pass_openings(CoupledRun& run, Real step);

/// The fields of the moment in the units of the case, made when they are first asked for. Asking is
/// collective; good until the next solve.
using MomentFields = std::function<const flow::StokesSolver::CellFields&()>;
[[nodiscard]] MomentFields fields_of_moment(CoupledRun& run);

/// Inlets follow the flow of the last solve: where and how fast particles enter, and how many.
void feed_inlets(CoupledRun& run);

/// Which limit of the case is reached, in words; "" when none is.
[[nodiscard]] std::string limit_reached(const CoupledRun& run);

}  // namespace porefines::sim
