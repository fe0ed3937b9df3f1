// SPDX-License-Identifier: MPL-2.0
// Creeping flow through cubic sphere arrays against Zick & Homsy (1982), references.md A1.
#include <gtest/gtest.h>

#include "support/solve.hpp"

namespace porefines::test {

namespace {

Real drag_error(int n, const std::vector<Vec3>& sites, Real fraction, Real exact,
                const Vec3& shift = {}, int* cycles = nullptr) {
  const Real a = sphere_radius(fraction, sites.size());
  const Outcome flow = solve({n, n, n}, 1.0 / n, {}, sphere_lattice(sites, a, shift), along_x());
  EXPECT_TRUE(flow.report.converged);
  EXPECT_LT(flow.flux_variation, 1e-6);
  if (cycles != nullptr) {
    *cycles = flow.report.cycles;
  }
  return drag_factor(a, sites.size(), flow.velocity.x) / exact - 1;
}

}  // namespace

TEST(SphereArrays, simple_cubic_converges) {
  constexpr Real exact = 7.441953;
  int cycles = 0;
  EXPECT_NEAR(drag_error(16, simple_cubic, 0.216, exact, {}, &cycles), 0, 0.010);
  EXPECT_LE(cycles, 10);
  EXPECT_NEAR(drag_error(32, simple_cubic, 0.216, exact, {}, &cycles), 0, 0.002);
  EXPECT_LE(cycles, 10);
  EXPECT_NEAR(drag_error(64, simple_cubic, 0.216, exact, {}, &cycles), 0, 0.0015);
  EXPECT_LE(cycles, 10);
}

TEST(SphereArrays, drag_hardly_depends_on_where_the_grid_lies) {
  constexpr int n = 32;
  Real least = 1;
  Real most = -1;
  // Offsets along the axes, the diagonals, and scattered ones (fractions of a cell).
  const std::vector<Vec3> offsets{{0, 0, 0},       {0.5, 0, 0},        {0.5, 0.5, 0},
                                  {0.5, 0.5, 0.5}, {0.25, 0, 0},       {0.1, 0.7, 0.4},
                                  {0.9, 0.2, 0.6}, {0.33, 0.81, 0.12}, {0.6, 0.45, 0.9}};
  for (const Vec3& offset : offsets) {
    const Real error = drag_error(n, simple_cubic, 0.216, 7.441953, offset / n);
    least = std::min(least, error);
    most = std::max(most, error);
  }
  std::printf("[ measured ] spread over offsets at 32^3: %.4f %%\n", 100 * (most - least));
  EXPECT_LT(most - least, 0.001);
}

struct Row {
  const char* lattice;
  Real fraction;
  Real exact;
};

class EveryRow : public ::testing::TestWithParam<Row> {};

TEST_P(EveryRow, within_half_a_percent_at_64_cells) {
  const Row row = GetParam();
  const auto& sites = std::string(row.lattice) == "sc"    ? simple_cubic
                      : std::string(row.lattice) == "bcc" ? body_centred
                                                          : face_centred;
  const Real error = drag_error(64, sites, row.fraction, row.exact);
  std::printf("[ measured ] %s %.3f: %.3f %%\n", row.lattice, row.fraction, 100 * error);
  EXPECT_NEAR(error, 0, 0.005);
}

INSTANTIATE_TEST_SUITE_P(TableA1, EveryRow,
                         ::testing::Values(Row{"sc", 0.027, 2.007748}, Row{"sc", 0.064, 2.810198},
                                           Row{"sc", 0.125, 4.291589}, Row{"sc", 0.343, 15.39949},
                                           Row{"sc", 0.45, 28.0863}, Row{"bcc", 0.064, 2.88938},
                                           Row{"bcc", 0.125, 4.44638}, Row{"bcc", 0.343, 16.33507},
                                           Row{"fcc", 0.064, 2.88875}, Row{"fcc", 0.125, 4.44572},
                                           Row{"fcc", 0.343, 16.63892}));

}  // namespace porefines::test
