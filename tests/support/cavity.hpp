// SPDX-License-Identifier: MPL-2.0
// The lid-driven cavity.
#pragma once

#include <gtest/gtest.h>

#include "flow/inertial_flow.hpp"
#include "support/solve.hpp"

namespace porefines::test {

struct Extrema {
  Real u_min, v_min, v_max;
};

/// Extremum of samples at cell centres of the unit length, by a parabola.
inline Real extremum(const std::vector<Real>& f, Real sign) {
  std::size_t best = 1;
  for (std::size_t i = 1; i + 1 < f.size(); ++i) {
    best = sign * f[i] > sign * f[best] ? i : best;
  }
  const Real slope = (f[best + 1] - f[best - 1]) / 2;
  const Real bend = f[best + 1] - 2 * f[best] + f[best - 1];
  return f[best] - slope * slope / (2 * bend);
}

/// Centre-line extrema of the steady flow under a lid of speed 1 on n x n cells.
inline Extrema cavity(int n, Real reynolds, Real tolerance = 1e-6) {
  const par::Communicator comm;
  Boundaries b;
  b.kind = {FaceKind::wall, FaceKind::wall, FaceKind::wall,
            FaceKind::lid,  FaceKind::slip, FaceKind::slip};
  const Real h = 1.0 / n;
  flow::StokesSolver solver(comm, even_cut({n, n, 1}, comm.size()), {h, h, h}, b, 1 / reynolds);
  solver.set_surface([](const Vec3&) { return 1e3; });
  flow::InertialFlow flow(solver, 1.0, flow::Scheme::linear, flow::TimeScheme::euler, 1.0);
  flow::Drive drive;
  drive.lid[3] = {1, 0, 0};
  const auto report = flow.settle(drive, {.tolerance = tolerance, .max_cycles = 60}, 2000);
  EXPECT_TRUE(report.converged);
  EXPECT_LE(report.cycles, reynolds <= 100 ? 200 : tolerance < 1e-6 ? 7000 : 5000);
  const auto u = solver.plane_velocities(0, n / 2);
  const auto v = solver.plane_velocities(1, n / 2);
  return {extremum(u, -1), extremum(v, -1), extremum(v, 1)};
}

}  // namespace porefines::test
