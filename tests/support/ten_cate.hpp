// SPDX-License-Identifier: MPL-2.0
// ten Cate et al. (2002): a sphere of 15 mm settles in a box of silicone oil, references.md B7.
#pragma once

#include <cmath>

#include <gtest/gtest.h>

#include "flow/inertial_flow.hpp"
#include "support/free_spheres.hpp"

namespace porefines::test {

struct Settling {
  Real density;    ///< [kg/m^3] of the oil
  Real viscosity;  ///< [Pa s]
  Real terminal;   ///< [m/s] in an unbounded fluid
};
inline constexpr Settling slow_settling{970, 0.373, 0.038};  ///< Re 1.5
inline constexpr Settling fast_settling{960, 0.058, 0.128};  ///< Re 31.9

/// Heights of the centre and speeds of the sphere until it is two cells above the bottom.
struct Fall {
  std::vector<Real> time, height, speed;
  Real peak = 0;  ///< largest speed over the terminal one
};

/// @param cells   per diameter: 6, 9, 12, 15 fit the box
/// @param travel  cells per step at the terminal speed
inline Fall settle(const Settling& q, int cells, Real travel) {
  const par::Communicator comm;
  const Real diameter = 0.015;
  const Real h = diameter / cells;
  const Int3 size{20 * cells / 3, 20 * cells / 3, 32 * cells / 3};
  flow::StokesSolver solver(comm, even_cut(size, comm.size()), {h, h, h}, closed_box(),
                            q.viscosity);
  solver.set_surface([](const Vec3&) { return 1e3; });
  flow::InertialFlow flow(solver, q.density, flow::Scheme::linear, flow::TimeScheme::bdf2,
                          q.terminal);
  flow::Sphere ball = sphere(1, {0.05, 0.05, 0.1275}, diameter / 2);
  ball.density = 1120;
  const Real volume = M_PI / 6 * diameter * diameter * diameter;
  ball.force = {0, 0, -9.81 * volume * (ball.density - q.density)};
  const Real step = travel * h / q.terminal;
  Fall fall;
  Vec3 before;
  while (ball.position.z > diameter / 2 + 2 * h && fall.time.size() < 2000) {
    const Vec3 move = 1.5 * ball.velocity - 0.5 * before;
    ball.position += move * step;
    const Real place = ball.position.z / h;
    const bool here = static_cast<int>(place) >= solver.block().start[2] &&
                      static_cast<int>(place) < solver.block().start[2] + solver.block().n[2];
    const std::vector<flow::Sphere> mine = here ? std::vector{ball} : std::vector<flow::Sphere>{};
    flow.set_spheres(mine);
    EXPECT_TRUE(flow.advance(step, {}, {.tolerance = 1e-5}).converged);
    before = ball.velocity_before = ball.velocity;
    Vec3 now = here ? flow.sphere_motions()[0].velocity : Vec3{};
    for (int a = 0; a < 3; ++a) {
      now[a] = comm.sum(now[a]);
    }
    ball.velocity = now;
    fall.time.push_back(flow.time());
    fall.height.push_back(ball.position.z);
    fall.speed.push_back(-now.z);
    fall.peak = std::max(fall.peak, -now.z / q.terminal);
  }
  return fall;
}

}  // namespace porefines::test
