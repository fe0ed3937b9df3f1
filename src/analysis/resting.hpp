// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/near_points.hpp"
#include "analysis/run_sample.hpp"

namespace porefines::analysis {

/// When a particle counts as retained, and when no longer.
///
/// It begins to rest where its speed is at most stop_share of the fluid's, and goes on resting while
/// it stays below twice that and within release_travel diameters of that place. After hold_time it
/// is retained, if it touches a wall or another that rests. A retained one is released when it has
/// left its place by release_travel diameters: jitter in place releases nothing.
struct RestRules {
  Real stop_share = 0.01;     ///< of the mean fluid speed in the pores, now; see least_share
  Real least_share = 0.01;    ///< that mean is never taken below this share of its largest so far,
                              ///< so that stopping the flow does not set everything free
  Real hold_time = 0;         ///< [s]
  Real release_travel = 0.5;  ///< diameters
  Real contact_gap = 0.05;    ///< diameters (of the smaller one) up to which two things touch
};

/// hold_time is what the fluid needs for five diameters: a particle at stop_share of its speed has
/// then come a twentieth of its diameter.
[[nodiscard]] RestRules default_rest_rules(Real mean_diameter, Real fluid_speed);

/// A particle that rests.
struct Resting {
  std::uint64_t id = 0;
  Vec3 place;      ///< [m] where it came to rest
  Real since = 0;  ///< [s]
  bool retained = false;
};

/// Two resting particles that touch, as places in the list of those that rest.
struct RestPair {
  std::int32_t a;
  std::int32_t b;
};

/// Who rests: the part of the state that a restart needs, and what was found at this sample.
struct RestState {
  std::vector<Resting> resting;  ///< in rising order of id
  Real fastest_fluid = 0;        ///< [m/s] largest mean so far

  // of this sample, in the order of `resting`
  std::vector<std::int32_t> place_in_sample;
  std::vector<RestPair> pairs;  ///< a < b, in rising order of (a, b)
};

/// Takes a sample. Cost O(particles). Ids that are gone are forgotten.
/// Tests: unit/clogging (jitter at the threshold, release, a stop without contact).
void update_resting(RestState& state, const RunSample& sample, const RestRules& rules,
                    const PointBox& box);

/// Does particle i of the sample touch a fixed wall?
[[nodiscard]] inline bool touches_wall(const RunSample& sample, std::size_t i,
                                       const RestRules& rules) {
  return sample.wall_gap[i] <= rules.contact_gap * 2 * sample.radius[i];
}

}  // namespace porefines::analysis
