// SPDX-License-Identifier: MPL-2.0
// The explicit scheme of the thesis beside the implicit solve: its drag error grows with the step.
#include "flow/rigid_projection.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "support/free_spheres.hpp"

namespace porefines::test {
namespace {

constexpr int n = 16;
constexpr Real fraction = 0.064;
constexpr Real gentle = 1e-6;  // force per volume: the Reynolds number is 1e-4
constexpr Real exact = 2.810;  // drag factor of the cubic array, Zick & Homsy 1982

flow::Sphere pulled(Real a) {
  flow::Sphere q = sphere(1, {n / 2.0 + 0.3, n / 2.0 + 0.3, n / 2.0 + 0.3}, a);
  q.force = {gentle * n * n * n, 0, 0};
  return q;
}

flow::Drive against() {
  flow::Drive back;
  back.force = {-gentle, 0, 0};
  return back;
}

/// Drag factor at the end of the transient, with steps of nu dt/h^2.
Real explicit_drag(Real step) {
  const par::Communicator comm;
  const Real a = n * sphere_radius(fraction, 1);
  flow::StokesSolver solver = open_box({n, n, n}, {}, comm);
  flow::InertialFlow flow(solver, 1.0, flow::Scheme::linear, flow::TimeScheme::euler,
                          gentle * n * n / 10);
  flow::RigidProjection scheme(solver, flow, 1.0, comm);
  const std::vector<flow::Sphere> spheres{pulled(a)};
  Real before = 0;
  for (Real time = 0; time < 20;) {  // the slowest mode decays in 6.5
    const auto m = scheme.advance(step, against(), spheres, {.tolerance = 1e-6});
    EXPECT_TRUE(scheme.report().converged);
    time += step;
    const Real drag = spheres[0].force.x / (6 * std::numbers::pi * a *
                                            (m[0].velocity.x - solver.superficial_velocity().x));
    if (std::abs(drag - before) < 1e-5 * step / (step + 1) * drag) {
      return drag;
    }
    before = drag;
  }
  return before;
}

}  // namespace

TEST(RigidProjection, drag_error_grows_with_the_step) {
  const Real a = n * sphere_radius(fraction, 1);
  flow::StokesSolver solver = open_box({n, n, n}, {});
  solver.set_spheres(std::vector{pulled(a)});
  EXPECT_TRUE(solver.solve(against(), to(1e-7)).converged);
  const Real implicit = pulled(a).force.x /
                        (6 * std::numbers::pi * a *
                         (solver.sphere_motions()[0].velocity.x - solver.superficial_velocity().x));
  std::printf("[ measured ] implicit %+.2f %%\n", 100 * (implicit / exact - 1));
  EXPECT_NEAR(implicit / exact, 1, 0.01);
  Real last = 2;
  for (const auto& [step, least, most] :
       {std::array{0.1, 0.9, 1.0}, {1.0, 0.7, 0.88}, {100.0, 0.6, 0.8}}) {
    const Real drag = explicit_drag(step) / exact;
    std::printf("[ measured ] explicit, nu dt/h^2 = %g: %+.1f %%\n", step, 100 * (drag - 1));
    EXPECT_GT(drag, least);
    EXPECT_LT(drag, most);
    EXPECT_LT(drag, last);
    last = drag;
  }
}

}  // namespace porefines::test
