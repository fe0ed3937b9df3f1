// SPDX-License-Identifier: MPL-2.0
// Cycles of the coupled solve do not grow with the number of spheres: 100 and 1,000 of 6 cells, a tenth
// of the fluid of a micromodel.
#include <gtest/gtest.h>

#include "support/crowded_chip.hpp"

namespace porefines::test {
namespace {

struct Count {
  int width;
  std::size_t spheres;
};

class ManySpheres : public ::testing::TestWithParam<Count> {};

std::vector<flow::Sphere> given(const CrowdedChip& chip,
                                const std::vector<flow::SphereMotion>& motions) {
  std::vector<flow::Sphere> out;
  for (std::size_t k = 0; k < chip.spheres.size(); ++k) {
    out.push_back(sphere(k, chip.spheres[k], chip.diameter / 2));
    if (!motions.empty()) {
      out.back().velocity = motions[k].velocity;
      out.back().spin = motions[k].spin;
    }
  }
  return out;
}

/// The fastest by half a cell; who would bump into something stays.
void move(CrowdedChip& chip, const std::vector<flow::SphereMotion>& motions) {
  Real fastest = 0;
  for (const flow::SphereMotion& m : motions) {
    fastest = std::max(fastest, norm(m.velocity));
  }
  for (std::size_t k = 0; k < motions.size(); ++k) {
    Vec3 x = chip.spheres[k] + (0.5 / fastest) * motions[k].velocity;
    x.x -= chip.width * std::floor(x.x / chip.width);
    x.y -= chip.width * std::floor(x.y / chip.width);
    if (chip.is_free(x, k)) {
      chip.spheres[k] = x;
    }
  }
}

}  // namespace

TEST_P(ManySpheres, take_few_cycles_cold_and_warm) {
  constexpr int depth = 24;
  CrowdedChip chip = crowd_chip(GetParam().width, depth, GetParam().spheres);
  ASSERT_EQ(chip.spheres.size(), GetParam().spheres);
  flow::StokesSolver solver(par::Communicator(), even_cut({chip.width, chip.width, depth}, 1),
                            {1, 1, 1}, slit_along_z(), 1.0);
  solver.set_surface([&](const Vec3& x) { return chip.distance(x); });
  const Real volume = std::numbers::pi / 6 * std::pow(chip.diameter, 3);
  std::printf(
      "[ measured ] %zu spheres, %.3f of the fluid\n", chip.spheres.size(),
      volume * static_cast<Real>(chip.spheres.size()) / static_cast<Real>(solver.fluid_cells()));

  solver.set_spheres(given(chip, {}));
  const flow::SolveReport cold = solver.solve(along_x(), to(1e-6));
  std::printf("[ measured ] cold to 1e-6: %d cycles\n", cold.cycles);
  EXPECT_LE(cold.cycles, 15);
  for (int step = 0; step < 3; ++step) {
    move(chip, solver.sphere_motions());
    solver.set_spheres(given(chip, solver.sphere_motions()));
    const flow::SolveReport warm = solver.solve(along_x(), to(1e-4));
    std::printf("[ measured ] warm to 1e-4: %d cycles\n", warm.cycles);
    EXPECT_LE(warm.cycles, 7);
  }
  solver.set_spheres(given(chip, solver.sphere_motions()));
  solver.solve(along_x(), to(1e-6));
  const auto warm = solver.sphere_motions();
  solver.forget();
  solver.set_spheres(given(chip, {}));
  solver.solve(along_x(), to(1e-6));
  const auto from_rest = solver.sphere_motions();
  Real squares = 0;
  Real wrong = 0;
  for (std::size_t k = 0; k < warm.size(); ++k) {
    const Vec3 d = warm[k].velocity - from_rest[k].velocity;
    wrong += dot(d, d);
    squares += dot(from_rest[k].velocity, from_rest[k].velocity);
  }
  std::printf("[ measured ] warm and cold differ by %.1e\n", std::sqrt(wrong / squares));
  EXPECT_LT(std::sqrt(wrong / squares), 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Numbers, ManySpheres, ::testing::Values(Count{100, 100}, Count{316, 1000}),
                         [](const auto& row) { return std::to_string(row.param.spheres); });

}  // namespace porefines::test
