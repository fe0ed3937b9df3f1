// SPDX-License-Identifier: MPL-2.0
// Spheres in small boxes, for verification and MPI tests.
#pragma once

#include <cmath>
#include <vector>

#include "mobility/box.hpp"
#include "support/solve.hpp"

namespace porefines::test {

using mobility::closed_box;
using mobility::open_box;
using mobility::slit_along_z;
using mobility::sphere;
using mobility::to;

/// Those of a list whose centres lie in this rank's block.
inline std::vector<flow::Sphere> mine(const flow::StokesSolver& solver,
                                      const std::vector<flow::Sphere>& all) {
  std::vector<flow::Sphere> out;
  for (const flow::Sphere& q : all) {
    bool inside = true;
    for (int a = 0; a < 3; ++a) {
      const int cell = static_cast<int>(std::floor(q.position[a]));
      inside = inside && cell >= solver.block().start[a] &&
               cell < solver.block().start[a] + solver.block().n[a];
    }
    if (inside) {
      out.push_back(q);
    }
  }
  return out;
}

}  // namespace porefines::test
