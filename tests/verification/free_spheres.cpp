// SPDX-License-Identifier: MPL-2.0
// Rigid spheres inside the Stokes solve against exact mobilities: references.md A1, B3, B6.
#include "support/free_spheres.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "mobility/known.hpp"

namespace porefines::test {
namespace {

/// Places of a sphere against the grid.
const std::vector<Vec3> offsets{{0.13, 0.30, 0.07}, {0.50, 0.51, -0.41}, {0.87, 0.72, 0.33}};

struct Slit {
  const char* name;
  int gap;      ///< H/a
  int size;     ///< D, cells
  Real height;  ///< z/a
  Real speed;   ///< U/U_max, exact
  Real spin;    ///< omega/(du/dz / 2), exact; 0: not compared
  Real allowed;
};

class FreeInSlit : public ::testing::TestWithParam<Slit> {};

}  // namespace

/// B3: force- and torque-free between parallel walls.
TEST_P(FreeInSlit, moves_and_turns_as_in_theory) {
  const Slit& q = GetParam();
  const int nz = q.gap * q.size / 2;
  const int nx = 4 * nz;
  flow::StokesSolver solver = open_box({nx, nx, nz}, slit_along_z());
  for (const Vec3& offset : offsets) {
    solver.forget();
    const Real z = q.height * q.size / 2;
    const Vec3 centre{nx / 2.0 + offset.x, nx / 2.0 + offset.y, z};
    solver.set_spheres(std::vector{sphere(1, centre, q.size / 2.0)});
    const flow::SolveReport report = solver.solve(along_x(), to(1e-6));
    EXPECT_TRUE(report.converged);
    EXPECT_LE(report.cycles, 12);
    const flow::SphereMotion m = solver.sphere_motions().front();
    const Real fastest = nz * nz / 8.0;
    EXPECT_NEAR(m.velocity.x / fastest / q.speed, 1, q.allowed) << q.name;
    if (q.spin != 0) {
      EXPECT_NEAR(m.spin.y / (0.25 * (nz - 2 * z)) / q.spin, 1, 0.02) << q.name;
    }
    EXPECT_LT(norm(m.force), 1e-4 * nz * nz) << "force of the fluid on a free sphere";
  }
}

INSTANTIATE_TEST_SUITE_P(B3, FreeInSlit,
                         ::testing::Values(Slit{"d6_h8", 8, 6, 4, 0.97903, 0, 0.01},
                                           Slit{"d6_h10", 10, 6, 5, 0.98662, 0, 0.01},
                                           Slit{"d6_h8_low", 8, 6, 1.5, 0.54991, 0.9232, 0.01},
                                           Slit{"d8_h8", 8, 8, 4, 0.97903, 0, 0.005},
                                           Slit{"d8_h8_low", 8, 8, 1.5, 0.54991, 0.9232, 0.005}),
                         [](const auto& row) { return row.param.name; });

/// A1, phi = 0.125: held in a stream, and pulled through fluid at rest. One drag, the exact one.
TEST(FreeSpheres, galilean_pair_in_a_cubic_array) {
  constexpr int n = 16;
  constexpr Real exact = 4.291589;
  const Real a = n * sphere_radius(0.125, 1);
  flow::StokesSolver solver = open_box({n, n, n}, {});
  for (const Vec3& offset : offsets) {
    flow::Sphere q = sphere(1, Vec3{8, 8, 8} + offset, a);
    const auto drag = [&](Real speed, Real force) {
      return force / (6 * std::numbers::pi * a * std::abs(speed));
    };
    q.held = true;
    solver.forget();
    solver.set_spheres(std::vector{q});
    EXPECT_TRUE(solver.solve(along_x(), to(1e-7)).converged);
    const Real held = drag(solver.superficial_velocity().x, n * n * n);
    EXPECT_NEAR(solver.sphere_motions().front().force.x / (n * n * n), 1, 1e-5);

    q.held = false;
    q.force = {1.0 * n * n * n, 0, 0};
    solver.forget();
    solver.set_spheres(std::vector{q});
    flow::Drive back;
    back.force = {-1, 0, 0};
    EXPECT_TRUE(solver.solve(back, to(1e-7)).converged);
    const Real moving = drag(
        solver.superficial_velocity().x - solver.sphere_motions().front().velocity.x, n * n * n);
    EXPECT_NEAR(moving / held, 1, 1e-4);
    EXPECT_NEAR(held / exact, 1, 0.012);
  }
}

/// B6.
TEST(FreeSpheres, turns_under_a_torque_and_with_a_shear_flow) {
  for (const int size : {6, 8}) {
    EXPECT_NEAR(mobility::turn_factor(size) * 1.013, 1, 0.01) << size << " cells per diameter";
  }
  EXPECT_NEAR(mobility::shear_spin(6), 1, 0.01);
  for (const int size : {6, 8}) {
    EXPECT_NEAR(mobility::intrinsic_viscosity(size), 2.5, 0.025) << size << " cells per diameter";
  }
}

/// Section 4: the answer depends neither on the guess nor on what the cells held before.
TEST(FreeSpheres, warm_equals_cold) {
  const Int3 cells{48, 32, 16};
  flow::StokesSolver solver = open_box(cells, slit_along_z());
  std::vector<flow::Sphere> all{sphere(1, {10.2, 9.1, 4.3}, 3), sphere(2, {16.4, 9.6, 5.1}, 3),
                                sphere(3, {30.2, 20.1, 11.8}, 3), sphere(4, {47.5, 31.2, 8}, 3)};
  solver.set_spheres(all);
  solver.solve(along_x(), to(1e-6));
  for (flow::Sphere& q : all) {  // the step: half a cell, and more
    q.position += Vec3{0.55, -0.13, 0.21};
    q.position.x -= q.position.x > 48 ? 48 : 0;
  }
  solver.set_spheres(all);
  EXPECT_LE(solver.solve(along_x(), to(1e-4)).cycles, 7);
  solver.set_spheres(all);
  solver.solve(along_x(), to(1e-6));
  const auto warm = solver.sphere_motions();
  solver.forget();
  EXPECT_LE(solver.solve(along_x(), to(1e-6)).cycles, 15);
  const auto cold = solver.sphere_motions();
  for (std::size_t q = 0; q < warm.size(); ++q) {
    EXPECT_LT(norm(warm[q].velocity - cold[q].velocity), 1e-5 * norm(cold[q].velocity));
    EXPECT_LT(norm(warm[q].spin - cold[q].spin), 1e-5 * norm(cold[q].velocity));
  }
}

/// Spheres gone, the grid is as it was.
TEST(FreeSpheres, leave_nothing_behind) {
  flow::StokesSolver solver = open_box({24, 16, 16}, slit_along_z());
  solver.solve(along_x(), to(1e-7));
  const Real before = solver.superficial_velocity().x;
  solver.set_spheres(std::vector{sphere(1, {8, 8, 8}, 3), sphere(2, {14.3, 8.2, 7.7}, 3)});
  solver.solve(along_x(), to(1e-7));
  EXPECT_LT(solver.superficial_velocity().x, 0.995 * before);
  solver.set_spheres({});
  solver.forget();
  solver.solve(along_x(), to(1e-7));
  EXPECT_NEAR(solver.superficial_velocity().x / before, 1, 1e-6);
}

/// A chain of touching spheres across a throat follows the flow as one: solved one by one it would
/// take hundreds of cycles (60 did not reach 1e-6, 14 do).
TEST(FreeSpheres, a_chain_that_touches_takes_no_more_cycles) {
  const Int3 cells{64, 24, 16};
  flow::StokesSolver solver = open_box(cells, slit_along_z());
  std::vector<flow::Sphere> chain;
  for (int k = 0; k < 9; ++k) {  // gaps of 0.003 cells, zigzag
    chain.push_back(sphere(static_cast<std::uint64_t>(k),
                           {6.3 + 5.65 * k, 12.2 + (k % 2 == 0 ? 1.0 : -1.0), 7.7}, 3));
    if (k > 0) {
      Vec3 way = chain[k].position - chain[k - 1].position;
      way *= 6.003 / norm(way);
      chain[k].position = chain[k - 1].position + way;
    }
  }
  solver.set_spheres(chain);
  const flow::SolveReport report = solver.solve(along_x(), to(1e-6));
  EXPECT_TRUE(report.converged);
  std::printf("[ measured ] %d cycles\n", report.cycles);
  EXPECT_LE(report.cycles, 15);
}

/// Drag does not tell where in its cell a sphere is: it varies by less than 1 % on the way across.
TEST(FreeSpheres, force_noise_while_crossing_cells) {
  constexpr int n = 24;
  for (const int size : {6, 8}) {
    flow::StokesSolver solver = open_box({n, n, n}, {});
    Real low = 1e30;
    Real high = 0;
    constexpr int places = 12;
    for (int k = 0; k < places; ++k) {  // two cells on, askew
      const Real way = 2.0 * k / places;
      flow::Sphere q = sphere(1, {9.1 + way, 10.3 + 0.41 * way, 11.2 + 0.23 * way}, size / 2.0);
      q.force = {1.0 * n * n * n, 0, 0};
      flow::Drive back;
      back.force = {-1, 0, 0};
      solver.set_spheres(std::vector{q});
      EXPECT_TRUE(solver.solve(back, to(1e-6)).converged);
      const Real speed =
          solver.sphere_motions().front().velocity.x - solver.superficial_velocity().x;
      low = std::min(low, speed);
      high = std::max(high, speed);
    }
    std::printf("[ measured ] D = %d: noise %.2f %%\n", size, 100 * (high / low - 1));
    EXPECT_LT(high / low - 1, 0.01);
  }
}

/// Section 6b: the forces on spheres and walls add up to the drive, f times the volume.
TEST(FreeSpheres, forces_balance_the_drive) {
  const Int3 cells{24, 16, 16};
  flow::StokesSolver solver = open_box(cells, {});  // periodic: spheres alone resist
  flow::Sphere one = sphere(1, {8.2, 8, 8}, 3);
  flow::Sphere two = sphere(2, {15.1, 8.2, 7.7}, 3);
  one.held = two.held = true;
  solver.set_spheres(std::vector{one, two});
  solver.solve(along_x(), to(1e-8));
  const auto m = solver.sphere_motions();
  EXPECT_NEAR((m[0].force.x + m[1].force.x) / product(cells), 1, 1e-6);
  EXPECT_NEAR((m[0].force.y + m[1].force.y) / product(cells), 0, 1e-6);
  EXPECT_GT(m[0].force.x, 0.3 * product(cells));
  EXPECT_GT(m[1].force.x, 0.3 * product(cells));
}

}  // namespace porefines::test
