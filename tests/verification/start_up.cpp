// SPDX-License-Identifier: MPL-2.0
// Flows that start from rest, against their series.
#include <gtest/gtest.h>

#include "flow/inertial_flow.hpp"
#include "support/solve.hpp"

namespace porefines::test {

namespace {

using flow::Scheme;
using flow::TimeScheme;

constexpr Real end = 0.1;

/// Between a wall at y = 0 and another that moves with speed 1 from t = 0 on; density and viscosity 1.
std::vector<Real> couette(int n, int steps, TimeScheme time) {
  const par::Communicator comm;
  Boundaries b;
  b.kind[2] = FaceKind::wall;
  b.kind[3] = FaceKind::lid;
  b.kind[4] = b.kind[5] = FaceKind::slip;
  const Real h = 1.0 / n;
  flow::StokesSolver solver(comm, even_cut({4, n, 1}, comm.size()), {h, h, h}, b, 1.0);
  solver.set_surface([](const Vec3&) { return 1e3; });
  flow::InertialFlow flow(solver, 1.0, Scheme::linear, time, 1.0);
  flow::Drive drive;
  drive.lid[3] = {1, 0, 0};
  for (int s = 0; s < steps; ++s) {
    EXPECT_TRUE(flow.advance(end / steps, drive, {.tolerance = 1e-8}).converged);
  }
  std::vector<Real> u = solver.plane_velocities(0, 0);
  const std::size_t next_to_wall = 0;
  u[next_to_wall] /= 0.875;  // the weight of half-cell links
  return u;
}

Real exact(Real y) {
  const Real pi = std::numbers::pi;
  Real u = y;
  for (int n = 1; n < 50; ++n) {
    u += (n % 2 == 0 ? 2 : -2) / (n * pi) * std::exp(-n * n * pi * pi * end) * std::sin(n * pi * y);
  }
  return u;
}

Real distance(const std::vector<Real>& a, const std::vector<Real>& b) {
  Real largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}

}  // namespace

TEST(StartUp, couette_order_in_time_as_chosen) {
  const auto best = couette(16, 400, TimeScheme::bdf2);
  for (const auto& [scheme, order] : {std::pair{TimeScheme::euler, 0.9}, {TimeScheme::bdf2, 1.9}}) {
    const Real coarse = distance(couette(16, 20, scheme), best);
    const Real fine = distance(couette(16, 40, scheme), best);
    EXPECT_GE(std::log2(coarse / fine), order) << coarse << " " << fine;
  }
}

TEST(StartUp, couette_order_in_space) {
  Real previous = 0;
  for (const int n : {16, 32}) {
    std::vector<Real> series;
    for (int j = 0; j < n; ++j) {
      series.push_back(exact((j + 0.5) / n));
    }
    const Real error = distance(couette(n, 400, TimeScheme::bdf2), series);
    EXPECT_TRUE(previous == 0 || std::log2(previous / error) >= 1.9) << previous << " " << error;
    previous = error;
  }
}

}  // namespace porefines::test
