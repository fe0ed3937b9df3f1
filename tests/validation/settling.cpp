// SPDX-License-Identifier: MPL-2.0
// ten Cate's settling sphere: a quarter of an hour on one core.
#include "support/ten_cate.hpp"

namespace porefines::test {

/// Without inertia the slow sphere would fall at 0.936 of u_inf in mid-box (Happel & Bart 1974, square duct: drag
/// 1.386 times Stokes's): below the 0.947 that the experiment reports with it. Its digitised heights give 0.91 to 0.93.
TEST(SettlingValidation, creeping_flow_bounds_the_slow_sphere) {
  for (const int cells : {6, 9}) {
    const Settling& q = slow_settling;
    const Real h = 0.015 / cells;
    const par::Communicator comm;
    const Int3 size{20 * cells / 3, 20 * cells / 3, 32 * cells / 3};
    flow::StokesSolver solver(comm, even_cut(size, comm.size()), {h, h, h}, closed_box(),
                              q.viscosity);
    solver.set_surface([](const Vec3&) { return 1e3; });
    flow::Sphere ball = sphere(1, {0.0501, 0.0501, 0.0801}, 0.0075);
    ball.force = {0, 0, -9.81 * M_PI / 6 * std::pow(0.015, 3) * (1120 - q.density)};
    solver.set_spheres(std::vector{ball});
    EXPECT_TRUE(solver.solve({}, to(1e-6)).converged);
    const Real speed = -solver.sphere_motions().front().velocity.z / q.terminal;
    std::printf("creeping: %.4f of u_inf\n", speed);
    EXPECT_NEAR(speed / 0.936, 1, 0.01);
  }
}

/// Peak speed over the terminal one, 12 cells per diameter: 0.947 (Re 1.5) and 0.955 (Re 31.9) in the experiment.
/// Found: 0.915 (9 cells) and 0.9432. references.md B7 accepts 5 %, as its two digitised figures differ by 3 to 5 %.
TEST(SettlingValidation, peak_speeds) {
  const Real slow = settle(slow_settling, 12, 0.5).peak;
  const Real fast = settle(fast_settling, 12, 0.5).peak;
  std::printf("peak speeds: %.4f, %.4f\n", slow, fast);
  EXPECT_NEAR(slow / 0.947, 1, 0.05);
  EXPECT_NEAR(fast / 0.955, 1, 0.03);
}

}  // namespace porefines::test
