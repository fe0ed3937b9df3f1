// SPDX-License-Identifier: MPL-2.0
// The flow does not depend on the number of ranks: one rank solves alone what all solve together.
#include <gtest/gtest.h>

#include "support/solve.hpp"

namespace porefines::test {

namespace {

struct Answer {
  Vec3 velocity;
  int cycles;
};

Answer answer(const par::Communicator& comm, const Int3& cells, const Boundaries& boundaries,
              const std::function<Real(const Vec3&)>& distance, const flow::Drive& drive,
              const Int3& per_length) {
  flow::StokesSolver solver(comm, even_cut(cells, comm.size()),
                            {1.0 / per_length[0], 1.0 / per_length[1], 1.0 / per_length[2]},
                            boundaries, 1.0);
  solver.set_surface(distance);
  const auto report = solver.solve(drive, {});
  EXPECT_TRUE(report.converged);
  return {solver.superficial_velocity(), report.cycles};
}

void expect_same(const Int3& cells, const Boundaries& boundaries,
                 const std::function<Real(const Vec3&)>& distance, const flow::Drive& drive,
                 const Int3& per_length) {
  const Answer alone =
      answer(par::Communicator::self(), cells, boundaries, distance, drive, per_length);
  const Answer together =
      answer(par::Communicator(), cells, boundaries, distance, drive, per_length);
  EXPECT_NEAR(together.velocity.x / alone.velocity.x, 1, 1e-6);
  EXPECT_NEAR(together.cycles, alone.cycles, 1);
}

void expect_same(const Int3& cells, const Boundaries& boundaries,
                 const std::function<Real(const Vec3&)>& distance, const flow::Drive& drive) {
  expect_same(cells, boundaries, distance, drive, {cells[0], cells[0], cells[0]});
}

}  // namespace

TEST(Ranks, periodic_spheres) {
  // Too large for one gathered level, so that blocks are coarsened while spread over the ranks.
  const auto spheres = sphere_lattice(face_centred, sphere_radius(0.3, 4), {0.013, 0.007, 0.021});
  expect_same({48, 48, 48}, {}, spheres, along_x());
}

TEST(Ranks, flat_cells) {
  const auto spheres = sphere_lattice(face_centred, sphere_radius(0.3, 4), {0.013, 0.007, 0.021});
  expect_same({80, 80, 32}, {}, spheres, along_x(), {80, 80, 32});
}

TEST(Ranks, odd_box_between_pressures) {
  Boundaries b;
  b.kind = {FaceKind::pressure, FaceKind::pressure, FaceKind::slip,
            FaceKind::wall,     FaceKind::periodic, FaceKind::periodic};
  flow::Drive drive;
  drive.face_value[0] = 1;
  const auto spheres = sphere_lattice(simple_cubic, 0.35);
  expect_same({67, 45, 67}, b, spheres, drive);
}

/// Wherever the box is cut: an opening on a cut axis is the only face of the ghost cell behind it.
TEST(Ranks, openings_on_every_cut_axis) {
  const par::Communicator comm;
  for (int axis = 0; axis < 3; ++axis) {
    Boundaries b;
    b.kind.fill(FaceKind::wall);
    b.kind[2 * axis] = b.kind[2 * axis + 1] = FaceKind::pressure;
    Int3 cells{12, 12, 12};
    cells[axis] = 9 * comm.size();
    Int3 ranks{1, 1, 1};
    ranks[axis] = comm.size();
    par::LayerWork work;
    for (int a = 0; a < 3; ++a) {
      work[a].assign(static_cast<std::size_t>(cells[a]), 1.0);
    }
    flow::StokesSolver solver(comm, par::decompose(cells, comm.size(), work, ranks), {1, 1, 1}, b,
                              1.0);
    solver.set_surface([](const Vec3&) { return 1e3; });
    flow::Drive drive;
    drive.face_value[2 * axis] = cells[axis];
    EXPECT_TRUE(solver.solve(drive, {}).converged);
    // A square duct: k = 0.0351442537 side^2, less the error of 12 cells (references.md A3).
    EXPECT_NEAR(solver.superficial_velocity()[axis] / (0.0351442537 * 144), 1, 0.01) << axis;
  }
}

TEST(Ranks, same_number_same_bits) {
  const auto spheres = sphere_lattice(simple_cubic, 0.4);
  const par::Communicator comm;
  const Answer first = answer(comm, {40, 40, 40}, {}, spheres, along_x(), {40, 40, 40});
  const Answer second = answer(comm, {40, 40, 40}, {}, spheres, along_x(), {40, 40, 40});
  EXPECT_EQ(first.velocity, second.velocity);
}

}  // namespace porefines::test
