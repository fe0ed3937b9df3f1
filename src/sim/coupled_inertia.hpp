// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "sim/coupled_state.hpp"

namespace porefines::sim {

// The sentences of the coupled loop where fluid and particles have inertia (regime = "navier-stokes").
//
// From t to t + dt, with M the mass of a sphere and of the fluid that it has to move (half its volume):
//
//     x, contacts:  M dv/dt = M A + F_contact          in substeps of the contacts, from V(t)
//     then, at the new places, fluid and spheres in one system:
//                   m (a0 V + a1 V_old + a2 V_older)/dt
//                       = F_fluid(V) + weight - buoyancy + (a0 P + a1 P_old + a2 P_older)/dt
//
// P being what contacts have given so far: by differences of the same kind, an impact of any shortness
// changes V in its own step and once for all (told as a force of one step, BDF2 would let it ring).
// A is the acceleration of the step before without its contacts, (V(t) - V(t - dt))/dt - F_contact/M: where
// nothing touches, places advance by AB2. Contacts thus act on the fluid within the step in which they
// happen, what they exchange is the same in both lines, and their restitution is that of the material;
// lubrication below the grid belongs to the solve, implicitly. Tests: cli/coupled_inertia.

/// [m/s] of the fastest particle to come: as given, or as it settles by itself, by viscosity or by
/// inertia with a drag coefficient of 0.4.
[[nodiscard]] Real particle_speed(const config::Case& the_case);

/// The flow with inertia, from the creeping flow of its drive; contacts as soft as the impact of what
/// falls or flows fastest allows. Collective.
void start_inertia(CoupledRun& run);

/// [s] until something has moved coupling.travel cells, half of a gap before a rebound has closed, the
/// Courant number of the fluid is reached, or the
/// next sample is due. Collective.
[[nodiscard]] Real choose_inertial_step(const CoupledRun& run);

/// The first line. Collective.
void move_with_inertia(CoupledRun& run, Real step);

/// The second one, for the step just made; at the start it only takes note of the motions that the
/// particles have. Collective.
/// @throws RunError  the solve did not converge
void solve_with_inertia(CoupledRun& run);

/// Goes on from a checkpoint, the particles being where they were. Collective.
void recall_inertia(CoupledRun& run, const flow::InertialFlow::Memory& memory);

}  // namespace porefines::sim
