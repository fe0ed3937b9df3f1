// SPDX-License-Identifier: MPL-2.0
#include "analysis/blocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace porefines::analysis {
namespace {

/// Half the breadth of a throat's section, normal to its chord: that of an ellipse of its area.
Real half_breadth(const geom::Throat& throat) {
  return 2 * throat.area / (std::numbers::pi * throat.width);
}

}  // namespace

Jam::Jam(const geom::PoreNetwork& network, const RunSample& sample, const RestState& state,
         const RestRules& rest, const BlockRules& rules)
    : network_(network),
      sample_(sample),
      state_(state),
      rest_(rest),
      rules_(rules),
      box_{network.size, network.periodic} {
  link(state);
  gather(state);
}

Real Jam::radius(std::int32_t k) const {
  return sample_
      .radius[static_cast<std::size_t>(state_.place_in_sample[static_cast<std::size_t>(k)])];
}

Vec3 Jam::way_from(const geom::Throat& throat, std::int32_t k) const {
  return box_.way(throat.centre, sample_.position[static_cast<std::size_t>(
                                     state_.place_in_sample[static_cast<std::size_t>(k)])]);
}

std::span<const std::int32_t> Jam::touching(std::int32_t k) const {
  const auto at = static_cast<std::size_t>(k);
  return std::span(neighbour_)
      .subspan(static_cast<std::size_t>(first_[at]),
               static_cast<std::size_t>(first_[at + 1] - first_[at]));
}

/// Neighbours of everyone, retained ones only.
void Jam::link(const RestState& state) {
  const auto retained = [&](std::int32_t k) {
    return state.resting[static_cast<std::size_t>(k)].retained;
  };
  first_.assign(state.resting.size() + 1, 0);
  for (const auto& [a, b] : state.pairs) {
    if (retained(a) && retained(b)) {
      ++first_[static_cast<std::size_t>(a) + 1];
      ++first_[static_cast<std::size_t>(b) + 1];
    }
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  neighbour_.resize(static_cast<std::size_t>(first_.back()));
  std::vector<std::int32_t> next(first_.begin(), first_.end() - 1);
  for (const auto& [a, b] : state.pairs) {
    if (retained(a) && retained(b)) {
      neighbour_[static_cast<std::size_t>(next[static_cast<std::size_t>(a)]++)] = b;
      neighbour_[static_cast<std::size_t>(next[static_cast<std::size_t>(b)]++)] = a;
    }
  }
}

bool Jam::is_large_for(const geom::Throat& throat, std::int32_t k) const {
  return 2 * radius(k) >= rules_.sieve_share * throat.width;
}

bool Jam::is_at(const geom::Throat& throat, const Vec3& way, Real diameter) const {
  const Real more = rules_.reach * diameter;
  const Real along = dot(way, throat.normal);
  const Real across = std::abs(dot(way, throat.across));
  const Real beside = std::abs(dot(way, cross(throat.normal, throat.across)));
  return along >= -throat.behind - more && along <= throat.ahead + more &&
         across <= 0.5 * throat.width + more &&
         (network_.flat || beside <= half_breadth(throat) + more);
}

void Jam::gather(const RestState& state) {
  std::vector<Vec3> centres;
  Real largest = 0;
  Real range = 0;
  for (std::size_t k = 0; k < state.resting.size(); ++k) {
    largest = std::max(largest, 2 * radius(static_cast<std::int32_t>(k)));
  }
  for (const geom::Throat& throat : network_.throats) {
    const Real more = rules_.reach * largest;
    centres.push_back(throat.centre);
    centres.back().z = network_.flat ? 0 : throat.centre.z;
    range = std::max(
        range, norm(Vec3{std::max(throat.behind, throat.ahead) + more, 0.5 * throat.width + more,
                         network_.flat ? 0 : half_breadth(throat) + more}));
  }
  const NearPoints near(centres, range, box_);
  std::vector<std::pair<std::int32_t, std::int32_t>> found;  // throat, particle
  sieve_.assign(state.resting.size(), -1);
  for (std::size_t k = 0; k < state.resting.size(); ++k) {
    if (!state.resting[k].retained) {
      continue;
    }
    const auto who = static_cast<std::int32_t>(k);
    Real nearest = std::numeric_limits<Real>::max();
    Vec3 x = sample_.position[static_cast<std::size_t>(state.place_in_sample[k])];
    x.z = network_.flat ? 0 : x.z;
    near.visit(x, [&](std::int32_t t, const Vec3&) {
      const geom::Throat& throat = network_.throats[static_cast<std::size_t>(t)];
      const Vec3 way = way_from(throat, who);
      if (!is_at(throat, way, 2 * radius(who))) {
        return;
      }
      found.emplace_back(t, who);
      if (is_large_for(throat, who) && norm(way) < nearest) {
        nearest = norm(way);
        sieve_[k] = t;
      }
    });
  }
  std::sort(found.begin(), found.end());
  for (const auto& [throat, who] : found) {
    if (crowds_.empty() || crowds_.back().throat != throat) {
      crowds_.push_back({throat, {}});
    }
    crowds_.back().members.push_back(who);
  }
}

/// Where the wall pushes across the throat; zero for one that leans on none or along it.
Vec3 Jam::support(const geom::Throat& throat, std::int32_t k) const {
  const auto i = static_cast<std::size_t>(state_.place_in_sample[static_cast<std::size_t>(k)]);
  if (!touches_wall(sample_, i, rest_)) {
    return {};
  }
  const Vec3& push = sample_.wall_normal[i];
  const Vec3 part = network_.flat ? dot(push, throat.across) * throat.across
                                  : push - dot(push, throat.normal) * throat.normal;
  return norm(part) >= rules_.least_support ? part : Vec3{};
}

Block Jam::find_sieve(const Crowd& crowd) const {
  const geom::Throat& throat = network_.throats[static_cast<std::size_t>(crowd.throat)];
  Block block;
  Real nearest = 0;
  for (const std::int32_t k : crowd.members) {
    const Vec3 way = way_from(throat, k);
    const Real along = dot(way, throat.normal);
    const Real beyond = std::max(along - throat.ahead, -throat.behind - along);
    const bool large = sieve_[static_cast<std::size_t>(k)] == crowd.throat;
    const bool over = std::abs(dot(way, throat.across)) <= 0.5 * throat.width;
    const Real funnel = support(throat, k) != Vec3{} ? 2 * (2 * radius(k) - throat.width) : 0;
    const bool stopped_there = beyond <= radius(k) + std::max(funnel, 0.0);
    if (large && over && stopped_there && (block.empty() || std::abs(along) < nearest)) {
      nearest = std::abs(along);
      block = {ClogKind::sieve, {k}, norm(way)};
    }
  }
  return block;
}

/// Breadth first from one that leans on a wall to the first that leans on an opposite one.
std::vector<std::int32_t> Jam::chain_from(std::size_t start,
                                          const std::vector<Leaning>& leaning) const {
  const auto place = [&](std::int32_t k) {
    const auto found =
        std::lower_bound(leaning.begin(), leaning.end(), k,
                         [](const Leaning& one, std::int32_t other) { return one.member < other; });
    return found != leaning.end() && found->member == k
               ? static_cast<std::size_t>(found - leaning.begin())
               : leaning.size();
  };
  std::vector<std::size_t> came_from(leaning.size(), leaning.size());
  std::vector<std::size_t> queue{start};
  came_from[start] = start;
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const std::size_t at = queue[head];
    if (dot(leaning[at].push, leaning[start].push) < 0) {
      std::vector<std::int32_t> chain{leaning[at].member};
      for (std::size_t back = at; back != start; back = came_from[back]) {
        chain.push_back(leaning[came_from[back]].member);
      }
      return chain;
    }
    for (const std::int32_t k : touching(leaning[at].member)) {
      const std::size_t next = place(k);
      if (next < leaning.size() && came_from[next] == leaning.size()) {
        came_from[next] = at;
        queue.push_back(next);
      }
    }
  }
  return {};
}

std::vector<std::int32_t> Jam::shortest_chain(const Crowd& crowd) const {
  const geom::Throat& throat = network_.throats[static_cast<std::size_t>(crowd.throat)];
  std::vector<Leaning> leaning;
  for (const std::int32_t k : crowd.members) {
    leaning.push_back({k, support(throat, k)});
  }
  std::vector<std::int32_t> shortest;
  for (std::size_t start = 0; start < leaning.size(); ++start) {
    if (leaning[start].push != Vec3{}) {
      auto chain = chain_from(start, leaning);
      if (!chain.empty() && (shortest.empty() || chain.size() < shortest.size())) {
        shortest = std::move(chain);
      }
    }
  }
  return shortest;
}

Block Jam::find_block(const Crowd& crowd) const {
  Block block = find_sieve(crowd);
  if (!block.empty()) {
    return block;
  }
  block = {ClogKind::arch, shortest_chain(crowd), 0};
  if (block.empty()) {
    return block;
  }
  const geom::Throat& throat = network_.throats[static_cast<std::size_t>(crowd.throat)];
  const auto along = [&](std::int32_t k) { return dot(way_from(throat, k), throat.normal); };
  Real behind = 0;
  Real ahead = 0;
  for (const std::int32_t k : block.members) {
    behind = std::min(behind, along(k));
    ahead = std::max(ahead, along(k));
  }
  for (const std::int32_t k : crowd.members) {
    const Real slack = 0.25 * radius(k);
    const bool inside = along(k) > behind - slack && along(k) < ahead + slack;
    const bool held = std::any_of(touching(k).begin(), touching(k).end(), [&](std::int32_t other) {
      return std::find(block.members.begin(), block.members.end(), other) != block.members.end();
    });
    if (inside && held) {
      block.members.push_back(k);
    }
  }
  std::sort(block.members.begin(), block.members.end());
  block.members.erase(std::unique(block.members.begin(), block.members.end()), block.members.end());
  Vec3 sum;
  for (const std::int32_t k : block.members) {
    sum += way_from(throat, k);
  }
  block.off = norm(sum) / static_cast<Real>(block.members.size());
  return block;
}

}  // namespace porefines::analysis
