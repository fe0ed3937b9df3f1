// SPDX-License-Identifier: MPL-2.0
// Straight ducts and slits against their exact flow, references.md A3 and A5.
#include <gtest/gtest.h>

#include "support/solve.hpp"

namespace porefines::test {

namespace {

Real open_box(const Vec3&) {
  return 1e3;
}

/// Permeability of a channel A x B x L with walls on y and z, relative to B^2.
Outcome duct(int length, int wide, int high, FaceKind ends, FaceKind sides) {
  Boundaries b;
  b.kind = {ends, ends, sides, sides, FaceKind::wall, FaceKind::wall};
  flow::Drive drive;
  const Real h = 1.0 / high;
  if (ends == FaceKind::pressure) {
    drive.face_value[0] = length * h;
  } else {
    drive.force = {1, 0, 0};
  }
  return solve({length, wide, high}, h, b, open_box, drive);
}

}  // namespace

TEST(Ducts, empty_chip_has_h_squared_over_12) {
  // A chip 20 um deep: 33.77 darcy. Slip sides, pressure at the ends.
  for (const auto& [cells, tolerance] : {std::pair{16, 0.0025}, std::pair{32, 0.0006}}) {
    const Outcome chip = duct(2 * cells, cells, cells, FaceKind::pressure, FaceKind::slip);
    const Real k = chip.velocity.x * std::pow(20e-6, 2) / darcy;
    EXPECT_NEAR(k / 33.77456 - 1, 0, tolerance) << cells << " cells deep";
    EXPECT_LT(chip.flux_variation, 1e-6);
  }
}

TEST(Ducts, at_least_second_order_towards_the_square_duct) {
  constexpr Real exact = 0.0351442537;
  Real previous = 0;
  for (const int n : {16, 32, 64}) {
    const Real error = duct(8, n, n, FaceKind::periodic, FaceKind::wall).velocity.x / exact - 1;
    if (previous != 0) {
      EXPECT_GE(std::log2(previous / error), 1.9) << n;
    }
    previous = error;
  }
  EXPECT_NEAR(previous, 0, 0.005);
}

TEST(Ducts, rectangles_at_64_cells) {
  EXPECT_NEAR(duct(8, 128, 64, FaceKind::periodic, FaceKind::wall).velocity.x / 0.0571704193, 1,
              0.005);
  EXPECT_NEAR(duct(4, 640, 64, FaceKind::periodic, FaceKind::wall).velocity.x / 0.0780812536, 1,
              0.005);
}

TEST(Ducts, pressure_ends_give_the_periodic_flow) {
  const Real driven = duct(19, 17, 17, FaceKind::pressure, FaceKind::wall).velocity.x;
  const Real periodic = duct(19, 17, 17, FaceKind::periodic, FaceKind::wall).velocity.x;
  EXPECT_NEAR(driven / periodic, 1, 1e-6);
}

TEST(Ducts, uniform_inlet_velocity_is_the_mean_velocity) {
  Boundaries b;
  b.kind = {FaceKind::velocity, FaceKind::pressure, FaceKind::slip,
            FaceKind::slip,     FaceKind::wall,     FaceKind::wall};
  flow::Drive drive;
  drive.face_value[0] = 2.5;
  const Outcome out = solve({40, 4, 16}, 0.1, b, open_box, drive);
  EXPECT_TRUE(out.report.converged);
  EXPECT_NEAR(out.velocity.x, 2.5, 1e-5);
}

TEST(Ducts, odd_and_thin_sizes_cost_no_more_cycles) {
  for (const Int3& cells : {Int3{101, 37, 3}, Int3{97, 61, 17}, Int3{33, 2, 29}, Int3{64, 31, 1}}) {
    const Outcome out = duct(cells[0], cells[1], cells[2], FaceKind::pressure, FaceKind::wall);
    EXPECT_TRUE(out.report.converged);
    EXPECT_LE(out.report.cycles, 12) << cells[0] << " x " << cells[1] << " x " << cells[2];
  }
}

}  // namespace porefines::test
