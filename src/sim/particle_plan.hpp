// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

#include "sim/plan.hpp"

namespace porefines::sim {

/// What the particles of a coupled run add to its plan.
struct ParticlePlan {
  Real diameter = 0;  ///< [m] of the smallest species, mean
  Real at_start = 0;  ///< particles; lists in files are not counted
  Real entering = 0;  ///< particles in the whole run
  Real steps = 0;
  Real memory = 0;   ///< [bytes] of all ranks
  Real seconds = 0;  ///< wall time of the steps
};

/// Steps: the fastest fluid, three times the mean in the pores, moves coupling.travel cells in each.
/// A step costs six cycles and the placing of the spheres, at the bandwidth that made plan.seconds
/// of the clean solve. As good as the guess of the velocity; a run says more once it knows its flow.
/// @param seconds_per_cycle  [s] of one cycle of the multigrid
[[nodiscard]] ParticlePlan plan_particles(const config::Case& the_case, const Domain& domain,
                                          Real porosity, Real darcy_velocity,
                                          Real seconds_per_cycle);

/// Lines for a person: fines, steps, time.
[[nodiscard]] std::vector<std::string> describe(const ParticlePlan& plan, const Domain& domain);

}  // namespace porefines::sim
