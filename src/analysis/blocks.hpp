// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/resting.hpp"
#include "geom/pore_network.hpp"

namespace porefines::analysis {

enum class ClogKind : std::uint8_t {
  sieve,  ///< one particle that is too large for the throat
  arch,   ///< several that hold each other between opposite walls
};

[[nodiscard]] inline const char* name_of(ClogKind kind) {
  return kind == ClogKind::sieve ? "sieve" : "arch";
}

/// What counts as a clog of a throat.
struct BlockRules {
  Real reach = 2;          ///< diameters beyond a throat's ends and sides that still belong to it
  Real sieve_share = 0.9;  ///< of the width, above which one particle alone is sieved: widths from
                           ///< pixels are good to a tenth at ten pixels
  Real least_support = 0.25;  ///< share of a wall's push that must act across the throat
};

/// What blocks a throat: places in RestState::resting, rising.
struct Block {
  ClogKind kind = ClogKind::sieve;
  std::vector<std::int32_t> members;
  Real off = 0;  ///< [m] from the throat's centre to the middle of the members

  [[nodiscard]] bool empty() const { return members.empty(); }
};

/// Retained particles, who touches whom, and which of them are at each throat.
class Jam {
 public:
  Jam(const geom::PoreNetwork& network, const RunSample& sample, const RestState& state,
      const RestRules& rest, const BlockRules& rules);

  /// Throats that have retained particles, rising, and those particles.
  struct Crowd {
    std::int32_t throat;
    std::vector<std::int32_t> members;
  };
  [[nodiscard]] const std::vector<Crowd>& crowds() const { return crowds_; }

  /// What blocks this throat; empty when it is free.
  ///
  /// - sieve: the particle nearest to the centre with d >= sieve_share width, at no nearer throat of
  ///   which the same holds, whose centre lies over the throat no more than a radius before its
  ///   ends; in a funnel, leaning on a wall, up to 2 (d - width) further;
  /// - arch: the shortest chain of contacts between two that lean on walls that push against each
  ///   other across the throat, and whoever of their neighbours lies as near to its section. In 3D
  ///   an arch need not close the whole section.
  [[nodiscard]] Block find_block(const Crowd& crowd) const;

  /// Retained particles that touch this one.
  [[nodiscard]] std::span<const std::int32_t> touching(std::int32_t k) const;

 private:
  struct Leaning {
    std::int32_t member;
    Vec3 push;  ///< of the wall, its part across the throat; 0: leans on none
  };
  void link(const RestState& state);
  void gather(const RestState& state);
  [[nodiscard]] Vec3 way_from(const geom::Throat& throat, std::int32_t k) const;
  [[nodiscard]] Real radius(std::int32_t k) const;
  [[nodiscard]] bool is_large_for(const geom::Throat& throat, std::int32_t k) const;
  [[nodiscard]] bool is_at(const geom::Throat& throat, const Vec3& way, Real diameter) const;
  [[nodiscard]] Vec3 support(const geom::Throat& throat, std::int32_t k) const;
  [[nodiscard]] Block find_sieve(const Crowd& crowd) const;
  [[nodiscard]] std::vector<std::int32_t> shortest_chain(const Crowd& crowd) const;
  [[nodiscard]] std::vector<std::int32_t> chain_from(std::size_t start,
                                                     const std::vector<Leaning>& leaning) const;

  const geom::PoreNetwork& network_;
  const RunSample& sample_;
  const RestState& state_;
  RestRules rest_;
  BlockRules rules_;
  PointBox box_;
  std::vector<std::int32_t> first_;  ///< per resting particle: where its neighbours start
  std::vector<std::int32_t> neighbour_;
  std::vector<Crowd> crowds_;
  std::vector<std::int32_t> sieve_;  ///< per resting particle: the nearest throat too narrow for it
};

}  // namespace porefines::analysis
