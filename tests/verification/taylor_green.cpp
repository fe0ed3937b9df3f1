// SPDX-License-Identifier: MPL-2.0
#include "support/taylor_green.hpp"

namespace porefines::test {

namespace {

using flow::Scheme;
using flow::TimeScheme;

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
