// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <optional>

#include "config/case.hpp"
#include "flow/stokes.hpp"
#include "sim/domain.hpp"

namespace porefines::sim {

/// The steady flow of a case, as the solver holds it, and how it becomes the one asked for.
///
/// Creeping flow is linear: a flow rate is reached by solving for a drop of 1 Pa and scaling,
///
///     u = scale u_solved,   p = scale p_solved + offset
///
/// and the outlet's pressure is an offset, so that 1e5 Pa of it costs no digits.
struct SteadyFlow {
  flow::SolveReport solve;  ///< cycles of all solves together; the largest residual
  int signal = 0;           ///< that ended the solve early, on any rank
  Real scale = 1;
  Real offset = 0;          ///< [Pa]
  Real flow_rate = 0;       ///< [m^3/s] along +axis, mean over all planes
  Real flux_variation = 0;  ///< (max - min) / mean over the planes normal to the flow
  Real pressure_drop = 0;   ///< [Pa] over the sample, low side minus high side
  Real total_drop = 0;      ///< [Pa] from face to face of the box, reservoirs included
  Real permeability = 0;    ///< [m^2]
  Vec3 velocity;            ///< [m/s] superficial, mean over the box
  std::optional<std::array<Vec3, 3>> tensor;  ///< [m^2] tensor[j][i] = k_ij: velocity i, drive j
};

/// What drives the flow between two openings, as the solver is told.
struct OpeningDrive {
  flow::Drive drive;
  Real wanted_rate = 0;  ///< [m^3/s] along +axis; 0: the drive is what is asked for
  Real base = 0;         ///< [Pa] the known pressure, at the inlet or at the outlet
  bool base_at_inlet = false;
};
[[nodiscard]] OpeningDrive opening_drive(const config::Flow& flow);

/// [Pa] over the sample, low side minus high side, as the solver holds it. Collective.
[[nodiscard]] Real sample_pressure_drop(const Domain& domain, const flow::Drive& drive,
                                        const flow::StokesSolver& solver);

/// The flow of the last solve between the planes where the sample begins and ends.
struct DarcyFlow {
  Real flow_rate = 0;       ///< [m^3/s] along +axis
  Real flux_variation = 0;  ///< (max - min) / mean over the planes normal to the flow
  Real pressure_drop = 0;   ///< [Pa] over the sample
  Real permeability = 0;    ///< [m^2] k = mu (Q/A) L / dp; not finite where nothing drops
};
/// Collective.
[[nodiscard]] DarcyFlow measure_darcy(const config::Case& the_case, const Domain& domain,
                                      const flow::Drive& drive, const flow::StokesSolver& solver);

/// Solves the case and measures it. Collective; the results are the same on every rank.
///
/// Periodic:  k = mu U / G with the mean gradient G.
/// Openings:  k = mu (Q/A) L / dp between the planes where the sample begins and ends.
/// Progress is shown on stderr by rank 0; a signal on any rank ends the solve between two cycles.
/// @throws RunError  no convergence within max_cycles, or numbers that are no longer finite
/// Tests: cli/permeability.
[[nodiscard]] SteadyFlow solve_steady_flow(const config::Case& the_case, const Domain& domain,
                                           flow::StokesSolver& solver,
                                           const par::Communicator& comm);

}  // namespace porefines::sim
