// SPDX-License-Identifier: MPL-2.0
#include "analysis/resting.hpp"

#include <algorithm>
#include <tuple>

namespace porefines::analysis {
namespace {

/// Goes on resting, or begins to?
bool rests(const RunSample& sample, std::size_t i, const Resting* before, Real stop_speed,
           const RestRules& rules, const PointBox& box) {
  const Real speed = norm(sample.velocity[i]);
  if (before == nullptr) {
    return speed <= stop_speed;
  }
  const Real gone = norm(box.way(before->place, sample.position[i]));
  const bool in_place = gone <= rules.release_travel * 2 * sample.radius[i];
  return in_place && (before->retained || speed <= 2 * stop_speed);
}

/// Both lists are sorted by id: one walk along them.
void renew_list(RestState& state, const RunSample& sample, Real stop_speed, const RestRules& rules,
                const PointBox& box) {
  std::vector<Resting> now;
  state.place_in_sample.clear();
  auto old = state.resting.begin();
  for (std::size_t i = 0; i < sample.id.size(); ++i) {
    while (old != state.resting.end() && old->id < sample.id[i]) {
      ++old;
    }
    const bool known = old != state.resting.end() && old->id == sample.id[i];
    if (known && rests(sample, i, &*old, stop_speed, rules, box)) {
      now.push_back(*old);
    } else if (rests(sample, i, nullptr, stop_speed, rules, box)) {
      now.push_back({sample.id[i], sample.position[i], sample.time, false});
    } else {
      continue;
    }
    state.place_in_sample.push_back(static_cast<std::int32_t>(i));
  }
  state.resting = std::move(now);
}

void find_pairs(RestState& state, const RunSample& sample, const RestRules& rules,
                const PointBox& box) {
  std::vector<Vec3> points;
  Real largest = 0;
  for (const std::int32_t i : state.place_in_sample) {
    points.push_back(sample.position[static_cast<std::size_t>(i)]);
    largest = std::max(largest, sample.radius[static_cast<std::size_t>(i)]);
  }
  const NearPoints near(points, 2 * largest * (1 + rules.contact_gap), box);
  state.pairs.clear();
  for (std::size_t a = 0; a < points.size(); ++a) {
    const Real ra = sample.radius[static_cast<std::size_t>(state.place_in_sample[a])];
    near.visit(points[a], [&](std::int32_t b, const Vec3& way) {
      if (static_cast<std::size_t>(b) <= a) {
        return;
      }
      const Real rb =
          sample
              .radius[static_cast<std::size_t>(state.place_in_sample[static_cast<std::size_t>(b)])];
      const Real reach = ra + rb + 2 * rules.contact_gap * std::min(ra, rb);
      if (dot(way, way) <= reach * reach) {
        state.pairs.push_back({static_cast<std::int32_t>(a), b});
      }
    });
  }
  std::sort(state.pairs.begin(), state.pairs.end(), [](const RestPair& p, const RestPair& q) {
    return std::tie(p.a, p.b) < std::tie(q.a, q.b);
  });
}

}  // namespace

RestRules default_rest_rules(Real mean_diameter, Real fluid_speed) {
  RestRules rules;
  rules.hold_time = fluid_speed > 0 ? 5 * mean_diameter / fluid_speed : 0;
  return rules;
}

void update_resting(RestState& state, const RunSample& sample, const RestRules& rules,
                    const PointBox& box) {
  state.fastest_fluid = std::max(state.fastest_fluid, sample.fluid_speed);
  const Real fluid = std::max(sample.fluid_speed, rules.least_share * state.fastest_fluid);
  renew_list(state, sample, rules.stop_share * fluid, rules, box);
  find_pairs(state, sample, rules, box);
  std::vector<char> touches(state.resting.size(), 0);
  for (const RestPair& pair : state.pairs) {
    touches[static_cast<std::size_t>(pair.a)] = touches[static_cast<std::size_t>(pair.b)] = 1;
  }
  for (std::size_t k = 0; k < state.resting.size(); ++k) {
    Resting& resting = state.resting[k];
    const bool held =
        touches[k] != 0 ||
        touches_wall(sample, static_cast<std::size_t>(state.place_in_sample[k]), rules);
    const bool long_enough = sample.time - resting.since >= rules.hold_time * (1 - 1e-9);
    resting.retained = resting.retained || (held && long_enough && sample.time > resting.since);
  }
}

}  // namespace porefines::analysis
