// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "dem/sizes.hpp"
#include "dem/system.hpp"

namespace porefines::dem {

/// Particles of one species that enter through a face of the box. Given once.
struct Inlet {
  BoxFace face = BoxFace::x_low;
  Vec3 low;   ///< [m] window in the face; the component along its normal is not looked at
  Vec3 high;  ///< [m]
  std::uint16_t species = 0;
  Real density = 0;  ///< [kg/m^3]
  Sizes sizes;
  bool by_number = false;  ///< what is counted up to the next entry: particles, or their volume
  Real rate = 0;           ///< [1/s] or [m^3/s] of particles while the inlet is open
  Real start = 0;          ///< [s]
  Real stop = 0;           ///< [s]
  Real period = 0;         ///< [s] of pulses; 0: always open between start and stop
  Real duration = 0;       ///< [s] of a pulse, at the beginning of each period
  Real velocity = 0;       ///< [m/s] inwards, where there is no flow
  /// Velocity of the flow [m/s]; the same on every rank. Entries are then where the flow carries
  /// them, in proportion to its normal component, and as fast as it is there.
  std::function<Vec3(const Vec3&)> flow;
  Real fastest_flow = 0;  ///< [m/s] upper bound of its normal component in the window
  std::uint64_t seed = 1;
  std::uint64_t stream = 0;  ///< sets the inlets of a run apart
};

/// What an inlet remembers; the same on every rank, and all that a checkpoint needs.
struct InletState {
  Real due = 0;                 ///< accumulated volume [m^3] or number
  Real entered = 0;             ///< of which so much is in the box
  std::uint64_t particles = 0;  ///< entered
  std::uint32_t tries = 0;      ///< draws of places so far, of the next particle
  Index waiting = 0;            ///< due, but found no room the last time
};

/// [s] for which the inlet was open until `time`.
[[nodiscard]] Real open_time(const Inlet& inlet, Real time);

/// Lets in what became due in (from, to], and what was left over before.
///
/// Particle k is due when the accumulated volume reaches sum_{i<=k} V_i (or the number k): times
/// follow from the rate, not from steps. It starts inside the face by its radius, and by what it has
/// travelled since it was due. It touches nothing there: each gets 64 tries for a place; when all
/// fail the rest waits, and is counted in `waiting`. No more than 4096 enter at once.
///
/// Collective: ranks share what is near the face, then find the same places.
/// @param next_id  of the next particle in the run; counted on
/// @return the particles that entered, on every rank
/// Tests: unit/dem_injection, mpi/injection.
std::vector<Body> let_in(System& system, const par::Communicator& comm, const Inlet& inlet,
                         InletState& state, Real from, Real to, std::uint64_t& next_id);

/// Share of random places in the window at which the largest particle would not touch a wall or
/// grain. Collective. Zero: the inlet is shut by rock.
[[nodiscard]] Real open_share(const System& system, const par::Communicator& comm,
                              const Inlet& inlet);

}  // namespace porefines::dem
