// SPDX-License-Identifier: MPL-2.0
// Particles for the synthetic microscope.
#pragma once

#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "vision/measures.hpp"
#include "vision/microscope.hpp"

namespace porefines::vision::test {

inline std::vector<Seen> random_particles(const Microscope& m, int count, std::uint64_t id,
                                          Real diameter = 4) {
  Draws draws(11, Stream::place, id);
  std::vector<Seen> out;
  for (int i = 0; i < count; ++i) {
    const Real x = draws.uniform(0, m.width - 1.0);
    const Real y = draws.uniform(0, m.height - 1.0);
    out.push_back({x, y, 0, diameter});
  }
  return out;
}

}  // namespace porefines::vision::test
