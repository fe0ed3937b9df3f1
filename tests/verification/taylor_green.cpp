// SPDX-License-Identifier: MPL-2.0
// The Taylor-Green vortex: an exact solution of the Navier-Stokes equations, periodic, two-dimensional.
//
//     u = U + cos(k(x - Ut)) sin(k(y - Vt)) e^(-2 nu k^2 t),   v = V - sin cos ...
#include <optional>

#include <gtest/gtest.h>

#include "flow/inertial_flow.hpp"
#include "support/solve.hpp"

namespace porefines::test {

namespace {

using flow::InertialFlow;
using flow::Scheme;
using flow::TimeScheme;

Boundaries flat() {
  Boundaries b;
  b.kind[4] = b.kind[5] = FaceKind::slip;
  return b;
}

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
  Flight(int n, Scheme scheme, TimeScheme time, const Vortex& vortex)
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
  [[nodiscard]] InertialFlow& flow() { return *flow_; }

 private:
  par::Communicator comm_;
  int n_;
  flow::StokesSolver solver_;
  std::optional<InertialFlow> flow_;
};

constexpr Real end = 0.25;

std::vector<Real> profile(int n, int steps, Scheme scheme, TimeScheme time, const Vortex& vortex) {
  Flight run(n, scheme, time, vortex);
  for (int s = 0; s < steps; ++s) {
    run.advance(end / steps, 1e-8);
  }
  return run.profile();
}

Real distance(const std::vector<Real>& a, const std::vector<Real>& b) {
  Real sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += (a[i] - b[i]) * (a[i] - b[i]);
  }
  return std::sqrt(sum / static_cast<Real>(a.size()));
}

}  // namespace

TEST(TaylorGreen, second_order_in_space) {
  const Vortex vortex{0.01, {0.3, 0.2, 0}};
  for (const Scheme scheme : {Scheme::linear, Scheme::lust}) {
    Real previous = 0;
    for (const int n : {32, 64}) {
      const std::vector<Real> found = profile(n, n / 2, scheme, TimeScheme::midpoint, vortex);
      std::vector<Real> exact;
      for (int j = 0; j < n; ++j) {
        exact.push_back(vortex({0, (j + 0.5) / n, 0}, end).x);
      }
      const Real error = distance(found, exact);
      EXPECT_TRUE(previous == 0 || std::log2(previous / error) >= 1.9) << previous << " " << error;
      previous = error;
    }
  }
}

TEST(TaylorGreen, order_in_time_as_chosen) {
  const Vortex vortex{0.01, {0.3, 0.2, 0}};
  const auto best = profile(16, 256, Scheme::linear, TimeScheme::midpoint, vortex);
  for (const auto& [scheme, order] :
       {std::pair{TimeScheme::euler, 0.95}, {TimeScheme::bdf2, 1.9}, {TimeScheme::midpoint, 1.9}}) {
    const Real coarse = distance(profile(16, 16, Scheme::linear, scheme, vortex), best);
    const Real fine = distance(profile(16, 32, Scheme::linear, scheme, vortex), best);
    EXPECT_GE(std::log2(coarse / fine), order);
  }
}

/// No viscosity, linear interpolation, Courant number 0.9: what is lost is the tolerance.
/// 10,000 steps: validation/inertia.
TEST(TaylorGreen, keeps_its_energy_without_viscosity) {
  Flight run(16, Scheme::linear, TimeScheme::midpoint, {1e-9, {0.3, 0.2, 0}});
  const Real before = run.flow().kinetic_energy();
  for (int s = 0; s < 100; ++s) {
    run.advance(0.9 / run.flow().crossing_rate(), 1e-8);
  }
  EXPECT_NEAR(run.flow().kinetic_energy() / before, 1, 2e-6);
}

}  // namespace porefines::test
