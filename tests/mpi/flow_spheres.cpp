// SPDX-License-Identifier: MPL-2.0
// Spheres on seams, corners and periodic borders: the same motion on any number of ranks.
#include <gtest/gtest.h>

#include "support/free_spheres.hpp"

namespace porefines::test {
namespace {

/// Velocities and spins by id, on every rank.
std::vector<Real> motions(flow::StokesSolver& solver, const std::vector<flow::Sphere>& owned,
                          std::size_t count, const par::Communicator& comm) {
  std::vector<Real> all(6 * count, 0);
  const auto found = solver.sphere_motions();
  for (std::size_t q = 0; q < owned.size(); ++q) {
    for (int a = 0; a < 3; ++a) {
      all[6 * owned[q].id + a] = found[q].velocity[a];
      all[6 * owned[q].id + 3 + a] = found[q].spin[a];
    }
  }
  if (comm.size() > 1) {
    comm.sum(all);
  }
  return all;
}

/// Cold, then two warm steps, on the ranks of a communicator.
std::vector<Real> run(const par::Communicator& comm) {
  const Int3 cells{40, 40, 32};
  flow::StokesSolver solver = open_box(cells, slit_along_z(), comm);
  // In the middle: on the seams of 2 and 4 ranks. On the borders: beyond them too. A touching trio.
  std::vector<flow::Sphere> all{
      sphere(0, {20, 20, 16}, 3),       sphere(1, {20.3, 26.05, 16.2}, 3),
      sphere(2, {23.2, 23.1, 20.4}, 3), sphere(3, {39.7, 0.4, 12}, 3.5),
      sphere(4, {0.1, 20.2, 3.01}, 3),  sphere(5, {10, 39.9, 28.9}, 3),
  };
  std::vector<Real> out;
  for (int step = 0; step < 3; ++step) {
    const auto owned = mine(solver, all);
    solver.set_spheres(owned);
    EXPECT_TRUE(solver.solve(along_x(), to(step == 0 ? 1e-7 : 1e-6)).converged);
    out = motions(solver, owned, all.size(), comm);
    for (flow::Sphere& q : all) {
      q.velocity = {out[6 * q.id], out[6 * q.id + 1], out[6 * q.id + 2]};
      q.position += 0.004 * q.velocity;
      for (int a = 0; a < 2; ++a) {
        q.position[a] -= cells[a] * std::floor(q.position[a] / cells[a]);
      }
    }
  }
  return out;
}

}  // namespace

TEST(FlowSpheres, same_motion_on_any_number_of_ranks) {
  const std::vector<Real> alone = run(par::Communicator::self());
  const std::vector<Real> together = run(par::Communicator());
  Real largest = 0;
  for (const Real value : alone) {
    largest = std::max(largest, std::abs(value));
  }
  for (std::size_t q = 0; q < alone.size(); ++q) {
    EXPECT_NEAR(together[q] / largest, alone[q] / largest, 2e-6) << "number " << q;
  }
}

TEST(FlowSpheres, bitwise_the_same_again) {
  EXPECT_EQ(run(par::Communicator()), run(par::Communicator()));
}

}  // namespace porefines::test
