// SPDX-License-Identifier: MPL-2.0
// Flow across square and hexagonal cylinder arrays against Sangani & Acrivos (1982), references.md A2.
#include <gtest/gtest.h>

#include "support/solve.hpp"

namespace porefines::test {

namespace {

struct Row {
  bool hexagonal;
  Real fraction;
  Real exact;  ///< F / (mu U) per unit length
};

/// Square: one cylinder in a unit cell. Hexagonal: two in a cell of 1 x sqrt(3).
Real force_error(const Row& row, int n) {
  const Real height = row.hexagonal ? std::sqrt(3.0) : 1.0;
  const int rows = static_cast<int>(std::lround(n * height));
  const Real h_y = height / rows;
  const int cylinders = row.hexagonal ? 2 : 1;
  const Real radius = std::sqrt(row.fraction * height / (std::numbers::pi * cylinders));
  const auto distance = [&](const Vec3& x) {
    Real nearest = 1e300;
    for (int c = 0; c < cylinders; ++c) {
      Real dx = x.x - 0.25 - 0.5 * c;
      Real dy = x.y - height / 4 - height / 2 * c;
      dx -= std::round(dx);
      dy -= height * std::round(dy / height);
      nearest = std::min(nearest, std::hypot(dx, dy) - radius);
    }
    return nearest;
  };
  const par::Communicator comm;
  flow::StokesSolver solver(comm, even_cut({n, rows, 1}, comm.size()), {1.0 / n, h_y, 1.0 / n}, {},
                            1.0);
  solver.set_surface(distance);
  EXPECT_TRUE(solver.solve(along_x(), {}).converged);
  const Real force = height / cylinders / solver.superficial_velocity().x;
  return force / row.exact - 1;
}

class CylinderArrayRow : public ::testing::TestWithParam<Row> {};

}  // namespace

TEST_P(CylinderArrayRow, within_half_a_percent_at_64_cells) {
  const Real error = force_error(GetParam(), 64);
  std::printf("[ measured ] %s %.2f: %.3f %%\n", GetParam().hexagonal ? "hexagonal" : "square",
              GetParam().fraction, 100 * error);
  EXPECT_NEAR(error, 0, 0.005);
}

// The narrowest gap of a row must be at least four cells: square 0.60 has 8 cells, hexagonal 0.70 has 7.8;
// square 0.70 has 3.6, below the limit. Its error on 64, 72, 80, 96, 112, 128 cells: -1.8, -0.8, 0.8,
// -0.3, 0.2, 0.3 %: within half a percent from five cells in the throat on.
INSTANTIATE_TEST_SUITE_P(TableA2, CylinderArrayRow,
                         ::testing::Values(Row{false, 0.05, 15.5578}, Row{false, 0.10, 24.8317},
                                           Row{false, 0.20, 51.527}, Row{false, 0.30, 102.88},
                                           Row{false, 0.40, 217.89}, Row{false, 0.50, 532.55},
                                           Row{false, 0.60, 1763.6}, Row{true, 0.05, 15.7377},
                                           Row{true, 0.10, 25.1320}, Row{true, 0.20, 51.1477},
                                           Row{true, 0.40, 185.77}, Row{true, 0.70, 2769.9}));

TEST(CylinderArrays, the_tightest_row_once_its_throat_has_five_cells) {
  const Real error = force_error({false, 0.70, 13518}, 96);
  std::printf("[ measured ] square 0.70 on 96 cells: %.3f %%\n", 100 * error);
  EXPECT_NEAR(error, 0, 0.005);
}

}  // namespace porefines::test
