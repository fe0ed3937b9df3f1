// SPDX-License-Identifier: MPL-2.0
// How far and how finely a dry run goes on, and whether it may.
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"
#include "dem/step_size.hpp"
#include "sim/dry_state.hpp"
#include "sim/tracks.hpp"

namespace porefines::sim {
namespace {

constexpr Index longest_stretch = 500;  ///< steps between two looks at signals and open faces

/// What the step depends on: particles inside, and those that will enter.
dem::Pace pace_of(const DryRun& run) {
  dem::Pace pace{run.the_case.contact.steps_per_contact, std::numeric_limits<Real>::max(),
                 norm(run.system.settings().gravity), run.system.top_speed()};
  const dem::Particles& p = run.system.particles();
  Real push = 0;
  for (std::size_t i = 0; i < p.owned; ++i) {
    pace.radius = std::min(pace.radius, p.radius[i]);
    push = std::max(push, norm(p.external_force[i]) * p.inverse_mass[i]);
  }
  for (const dem::Inlet& inlet : run.inlets) {
    pace.radius = std::min(pace.radius, dem::smallest_diameter(inlet.sizes) / 2);
    pace.speed = std::max(pace.speed, inlet.velocity);
  }
  pace.radius = run.comm.min(pace.radius);
  pace.acceleration += run.comm.max(push);
  return pace;
}

}  // namespace

Real next_sample(const DryRun& run) {
  Real next = run.the_case.run.end_time;
  for (std::size_t k = 0; k < config::output_kinds; ++k) {
    const auto kind = static_cast<config::OutputKind>(k);
    const auto at = static_cast<Real>(std::max<Index>(run.state.written[k], 1));  // the first: at 0
    if (is_sampled(run.the_case, kind)) {
      next = std::min(next, at * sample_interval(run.the_case, kind));
    }
  }
  return next;
}

Real longest_step(const DryRun& run) {
  return dem::longest_step(run.system, pace_of(run));
}

Stretch choose_stretch(const DryRun& run) {
  const dem::Pace pace = pace_of(run);
  const Real left = next_sample(run) - run.state.time;
  const Real longest = std::min(dem::longest_step(run.system, pace), left);
  Real stretch = std::min(left, static_cast<Real>(longest_stretch) * longest);
  if (!run.inlets.empty()) {
    // or what enters would be late by more than its radius
    stretch = std::min(stretch, pace.radius / dem::impact_speed(pace));
  }
  const auto count = std::max<Index>(1, static_cast<Index>(std::ceil(stretch / longest - 1e-9)));
  return {stretch / static_cast<Real>(count), count};
}

void advance_clock(DryState& state, const Stretch& stretch, Real due) {
  const Real time = state.time + stretch.step * static_cast<Real>(stretch.count);
  state.time = std::abs(time - due) <= 1e-9 * stretch.step ? due : time;
  state.steps += stretch.count;
  state.step = stretch.step;
}

void advance(DryRun& run, const Stretch& stretch) {
  run.system.advance(stretch.step, stretch.count);
  advance_clock(run.state, stretch, next_sample(run));
}

void require_healthy(const DryRun& run) {
  const Real overlap = run.system.largest_overlap();
  const Real most = run.the_case.contact.max_overlap;
  if (overlap <= most) {
    return;
  }
  Real young = 0;
  for (const config::Particles& p : run.the_case.particles) {
    young = std::max(young, p.young);
  }
  throw RunError(fmt::format(
      "two particles, or one and a wall, overlap by {:.3g} of a radius at {:.6g} s; [contact] "
      "max_overlap is {:.3g}\ntry young = \"{:.2g} Pa\" (now {:.2g} Pa), since overlaps go with "
      "young^"
      "(-2/5); or a larger max_overlap",
      overlap, run.state.time, most, 1.2 * young * std::pow(overlap / most, 2.5), young));
}

}  // namespace porefines::sim
