// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geom/round_bodies.hpp"

namespace porefines::geom {

/// A random packing to make.
struct PackSpec {
  int dims = 3;          ///< 2: discs, 3: spheres
  Vec3 size;             ///< [m] box
  bool periodic = true;  ///< else bodies stay inside the box
  Real porosity = 0.4;
  Real diameter = 0;  ///< [m] mean
  Real spread = 0;    ///< standard deviation / mean, lognormal, cut at mean/4 and 4 mean
  Real gap = 0;       ///< [m] least distance between surfaces
  std::uint64_t seed = 1;
};

/// Discs or spheres without overlap that leave exactly the porosity asked for.
///
/// Sizes are drawn until the grain volume is reached and then scaled (by less than half a grain)
/// to meet it; random positions are relaxed by pushing apart pairs nearer than `gap`, each by half
/// of what is missing, until none is (fictitious radii r + gap/2; least overlap 1e-6 diameter).
/// Errors: InputError when that does not end within 2500 rounds: too dense (5000 equal spheres
/// reach porosity 0.39; discs about 0.18; gaps count as grain).
/// Cost: about 2 us per body and round; a few rounds when loose, a thousand near the limit. Test: unit/geom_generate.
[[nodiscard]] std::vector<Body> make_packing(const PackSpec& spec);

/// Rows `x y z r` or `x y r` in m with a '#' header.
void write_bodies(const std::string& path, const std::vector<Body>& bodies, const PackSpec& spec);

}  // namespace porefines::geom
