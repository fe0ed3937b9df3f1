// SPDX-License-Identifier: MPL-2.0
// Spheres in small boxes, for verification and MPI tests.
#pragma once

#include <cmath>
#include <vector>

#include "support/solve.hpp"

namespace porefines::test {

/// A solver of unit cells and unit viscosity without grains.
inline flow::StokesSolver open_box(const Int3& cells, const Boundaries& boundaries,
                                   const par::Communicator& comm = par::Communicator()) {
  flow::StokesSolver solver(comm, even_cut(cells, comm.size()), {1, 1, 1}, boundaries, 1.0);
  solver.set_surface([](const Vec3&) { return 1e3; });
  return solver;
}

inline Boundaries slit_along_z() {
  Boundaries walls;
  walls.kind[4] = walls.kind[5] = FaceKind::wall;
  return walls;
}

inline Boundaries closed_box() {
  Boundaries walls;
  walls.kind.fill(FaceKind::wall);
  return walls;
}

inline flow::Sphere sphere(std::uint64_t id, const Vec3& position, Real radius) {
  flow::Sphere q;
  q.id = id;
  q.position = position;
  q.radius = radius;
  return q;
}

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

inline flow::SolveOptions to(Real tolerance) {
  flow::SolveOptions options;
  options.tolerance = tolerance;
  return options;
}

}  // namespace porefines::test
