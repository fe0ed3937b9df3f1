// SPDX-License-Identifier: MPL-2.0
// Cells that are long along one or two axes: the coarse grids halve the short sides first.
#include <gtest/gtest.h>

#include "support/solve.hpp"

namespace porefines::test {

namespace {

/// Drag factor of a simple cubic array of spheres, solid fraction 0.216, on n[0] x n[1] x n[2] cells.
struct Array {
  Real drag = 0;
  int cycles = 0;
  bool converged = false;
};

Array simple_cubic_array(const Int3& n) {
  const par::Communicator comm;
  Boundaries periodic;
  periodic.kind.fill(FaceKind::periodic);
  const Real radius = sphere_radius(0.216, 1);
  flow::StokesSolver solver(comm, even_cut(n, comm.size()), {1.0 / n[0], 1.0 / n[1], 1.0 / n[2]},
                            periodic, 1.0);
  solver.set_surface(sphere_lattice(simple_cubic, radius));
  const flow::SolveReport report = solver.solve(along_x(), {});
  return {drag_factor(radius, 1, solver.superficial_velocity().x), report.cycles, report.converged};
}

}  // namespace

class FlatCells : public ::testing::TestWithParam<Int3> {};

TEST_P(FlatCells, converge_like_cubes) {
  const Array array = simple_cubic_array(GetParam());
  EXPECT_TRUE(array.converged);
  EXPECT_LE(array.cycles, 14);               // 7 to 13 seen; cubes take 6
  constexpr Real exact = 7.441953;           // references.md A1
  EXPECT_NEAR(array.drag / exact, 1, 0.06);  // spheres are 9 to 12 cells across on the long side
}

INSTANTIATE_TEST_SUITE_P(Aspect, FlatCells,
                         ::testing::Values(Int3{64, 64, 16}, Int3{16, 64, 64}, Int3{64, 16, 16},
                                           Int3{96, 96, 12}, Int3{12, 96, 96}, Int3{12, 12, 96},
                                           Int3{96, 97, 13}));

}  // namespace porefines::test
