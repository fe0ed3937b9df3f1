// SPDX-License-Identifier: MPL-2.0
// The Taylor-Green vortex: an exact solution of the Navier-Stokes equations, periodic, two-dimensional.
//
//     u = U + cos(k(x - Ut)) sin(k(y - Vt)) e^(-2 nu k^2 t),   v = V - sin cos ...
#pragma once

#include <cmath>
#include <numbers>
#include <optional>

#include <gtest/gtest.h>

#include "flow/inertial_flow.hpp"
#include "support/solve.hpp"

namespace porefines::test {

struct Vortex {
  Real viscosity;
  Vec3 drift;
  [[nodiscard]] Vec3 operator()(const Vec3& x, Real t) const {
    const Real k = 2 * std::numbers::pi;
    const Real a = k * (x.x - drift.x * t);
    const Real b = k * (x.y - drift.y * t);
    const Real left = std::exp(-2 * viscosity * k * k * t);
    return drift + Vec3{std::cos(a) * std::sin(b) * left, -std::sin(a) * std::cos(b) * left, 0};
  }
};

/// A vortex on n x n cells of the unit square.
class Flight {
 public:
  Flight(int n, flow::Scheme scheme, flow::TimeScheme time, const Vortex& vortex)
      : n_(n),
        solver_(comm_, even_cut({n, n, 1}, comm_.size()), {1.0 / n, 1.0 / n, 1.0 / n}, flat(),
                vortex.viscosity) {
    solver_.set_surface([](const Vec3&) { return 1e3; });
    flow_.emplace(solver_, 1.0, scheme, time, 1.0);
    flow_->set_velocity([&](const Vec3& x) { return vortex(x, 0); });
  }
  void advance(Real step, Real tolerance) {
    const flow::StepReport report = flow_->advance(step, {}, {.tolerance = tolerance});
    EXPECT_TRUE(report.converged);
  }
  /// u on the plane x = 0.
  [[nodiscard]] std::vector<Real> profile() const { return solver_.plane_velocities(0, 0); }
  [[nodiscard]] flow::InertialFlow& flow() { return *flow_; }

  [[nodiscard]] static Boundaries flat() {
    Boundaries b;
    b.kind[4] = b.kind[5] = FaceKind::slip;
    return b;
  }

 private:
  par::Communicator comm_;
  int n_;
  flow::StokesSolver solver_;
  std::optional<flow::InertialFlow> flow_;
};

}  // namespace porefines::test
