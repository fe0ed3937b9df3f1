// SPDX-License-Identifier: MPL-2.0
// Solves small exact cases: what verification and MPI tests share.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include "flow/stokes.hpp"
#include "mobility/box.hpp"

namespace porefines::test {

using flow::Boundaries;
using flow::FaceKind;

using mobility::along_x;
using mobility::even_cut;

struct Outcome {
  flow::SolveReport report;
  Vec3 velocity;  ///< superficial, for unit force and viscosity
  Real flux_variation = 0;
};

/// Flow driven by a unit force along x in a box with unit spacing times `spacing`, viscosity 1.
inline Outcome solve(const Int3& cells, Real spacing, const Boundaries& boundaries,
                     const std::function<Real(const Vec3&)>& distance, const flow::Drive& drive) {
  const par::Communicator comm;
  flow::StokesSolver solver(comm, even_cut(cells, comm.size()), {spacing, spacing, spacing},
                            boundaries, 1.0);
  solver.set_surface(distance);
  Outcome out;
  out.report = solver.solve(drive, {});
  out.velocity = solver.superficial_velocity();
  const auto flux = solver.plane_fluxes(0);
  const auto [low, high] = std::minmax_element(flux.begin(), flux.end());
  out.flux_variation = (*high - *low) / std::abs(*high);
  return out;
}

/// Distance to a lattice of equal spheres in the unit box (periodic), centres at `sites` + shift.
inline std::function<Real(const Vec3&)> sphere_lattice(const std::vector<Vec3>& sites, Real radius,
                                                       const Vec3& shift = {}) {
  return [=](const Vec3& x) {
    Real nearest = 1e300;
    for (const Vec3& site : sites) {
      Vec3 d = x - site - shift;
      for (int a = 0; a < 3; ++a) {
        d[a] -= std::round(d[a]);
      }
      nearest = std::min(nearest, norm(d) - radius);
    }
    return nearest;
  };
}

inline const std::vector<Vec3> simple_cubic{{0.5, 0.5, 0.5}};
inline const std::vector<Vec3> body_centred{{0.25, 0.25, 0.25}, {0.75, 0.75, 0.75}};
inline const std::vector<Vec3> face_centred{
    {0.25, 0.25, 0.25}, {0.75, 0.75, 0.25}, {0.75, 0.25, 0.75}, {0.25, 0.75, 0.75}};

inline Real sphere_radius(Real solid_fraction, std::size_t spheres) {
  return std::cbrt(3 * solid_fraction / (4 * std::numbers::pi * static_cast<Real>(spheres)));
}

/// Drag factor K of F = 6 pi mu a K U per sphere, from the superficial velocity under a unit force.
inline Real drag_factor(Real radius, std::size_t spheres, Real velocity) {
  return 1 / (6 * std::numbers::pi * radius * velocity * static_cast<Real>(spheres));
}

}  // namespace porefines::test
