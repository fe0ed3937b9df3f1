// SPDX-License-Identifier: MPL-2.0
#include <gtest/gtest.h>

#include "flow/bridges.hpp"
#include "support/solve.hpp"

namespace porefines::test {
namespace {

/// A duct along x, 4 x 4 cells wide, with a chamber of 6 x 4 x 4 cells above it. They are joined by
/// `passages` throats one cell wide and two cells long.
class DuctWithChamber {
 public:
  explicit DuctWithChamber(int passages) : passages_(passages) {}
  bool operator()(int i, int j, int k) const {
    if (k < 1 || k > 4) {
      return false;
    }
    i = (i + 24) % 24;
    const bool duct = j >= 1 && j <= 4;
    const bool chamber = j >= 7 && j <= 10 && i >= 8 && i <= 13;
    const bool throat = (j == 5 || j == 6) && k == 2 && (i == 9 || (passages_ > 1 && i == 12));
    return duct || chamber || throat;
  }

 private:
  int passages_;
};

struct Flowed {
  Index open_throat_faces = 0;
  flow::SolveReport report;
  Real velocity = 0;
};

Flowed solve_with(int passages) {
  Boundaries b;
  b.kind = {FaceKind::periodic, FaceKind::periodic, FaceKind::wall,
            FaceKind::wall,     FaceKind::wall,     FaceKind::wall};
  const par::Communicator self = par::Communicator::self();
  flow::StokesSolver solver(self, even_cut({24, 12, 6}, 1), {1, 1, 1}, b, 1.0);
  solver.set_voxels(DuctWithChamber(passages));
  Flowed out;
  const flow::Level& level = solver.hierarchy().finest();
  for (int i = 0; i < 24; ++i) {
    out.open_throat_faces += level.inverse_diagonal[1][level.block.at(i, 6, 2)] != 0 ? 1 : 0;
  }
  out.report = solver.solve(along_x(), {});
  out.velocity = solver.superficial_velocity().x;
  return out;
}

TEST(Bridges, a_pocket_behind_one_throat_is_cut_off) {
  const Flowed flow = solve_with(1);
  EXPECT_EQ(flow.open_throat_faces, 0);
  EXPECT_TRUE(flow.report.converged);
  EXPECT_LE(flow.report.cycles, 12);
}

TEST(Bridges, a_chamber_with_two_throats_keeps_its_flow) {
  const Flowed two = solve_with(2);
  EXPECT_EQ(two.open_throat_faces, 2);
  EXPECT_TRUE(two.report.converged);
  EXPECT_LE(two.report.cycles, 16);
  EXPECT_GT(two.velocity, solve_with(1).velocity) << "a way beside the duct lets more through";
}

TEST(Bridges, flow_past_a_pocket_is_that_of_the_duct_with_a_notch) {
  const auto notched = [](int i, int j, int k) {
    return DuctWithChamber(1)(i, j, k) && j <= 5;  // the throat's first cell is a dead end as well
  };
  Boundaries b;
  b.kind = {FaceKind::periodic, FaceKind::periodic, FaceKind::wall,
            FaceKind::wall,     FaceKind::wall,     FaceKind::wall};
  flow::StokesSolver solver(par::Communicator::self(), even_cut({24, 12, 6}, 1), {1, 1, 1}, b, 1.0);
  solver.set_voxels(notched);
  flow::SolveOptions options;
  options.tolerance = 1e-9;
  solver.solve(along_x(), options);
  EXPECT_NEAR(solve_with(1).velocity / solver.superficial_velocity().x, 1, 1e-5);
}

}  // namespace
}  // namespace porefines::test
