// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dem/particles.hpp"

namespace porefines::dem {

/// Pairs first[k] < second[k] of particles nearer than a skin, sorted by first, then second.
/// The first is always owned; the second may be a ghost.
struct PairList {
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> second;

  [[nodiscard]] std::size_t size() const { return first.size(); }
};

/// Finds all pairs whose surfaces are nearer than `skin` [m].
///
/// Particles are sorted into grids by size, one per power of two of the radius; each looks for
/// partners among its own size and the larger ones. Cost O(N) for any size distribution:
/// a large particle among many small ones is found by them in its own coarse grid.
/// Test: unit/dem_pair_list (against all pairs, sizes up to 1:20).
/// @return  distances that were computed, to count work
Index find_pairs(const Particles& particles, Real skin, PairList& out);

/// The order that puts neighbours in space next to each other in memory (Morton order of cells of
/// side `cell` [m]); ties by the present order. Owned particles only.
[[nodiscard]] std::vector<std::uint32_t> spatial_order(const Particles& particles, Real cell);

}  // namespace porefines::dem
