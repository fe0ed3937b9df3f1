// SPDX-License-Identifier: MPL-2.0
// A filter cake as a run left it: 161 fines of 10 um, four cells each, before and on a sieve of 16 grains, with the contact
// forces of the moment (tests/data/plug.csv). Cakes are where warm solves once stalled.
#include <cmath>

#include <gtest/gtest.h>

#include "io/read_table.hpp"
#include "support/free_spheres.hpp"

namespace porefines::test {
namespace {

constexpr Real um = 1e-6;
constexpr Real cell = 2.5 * um;
constexpr Real width = 60 * um;
const Int3 cells{88, 24, 24};

constexpr Real pitch = 15 * um;

/// From the nearest of 4 x 4 grains of 14 um in a plane, periodic; others are `steps` further on.
Vec3 from_grain(const Vec3& x, const Int3& steps = {0, 0, 0}) {
  const auto off = [](Real y, int step) {
    return y - pitch * (std::floor(y / pitch) + 0.5 + step);
  };
  return {x.x - 180 * um, off(x.y, steps[1]), off(x.z, steps[2])};
}

Real sieve(const Vec3& x) {
  return norm(from_grain(x)) - 7 * um;
}

/// Gaps to grains that lubrication sees.
std::vector<flow::WallGap> gaps_of(const std::vector<flow::Sphere>& spheres) {
  std::vector<flow::WallGap> gaps;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    grid::for_window({0, -1, -1}, {0, 1, 1}, [&](const Int3& steps) {
      const Vec3 way = from_grain(spheres[i].position, steps);
      const Real gap = norm(way) - 7 * um - spheres[i].radius;
      if (gap < flow::lubrication_range * cell) {
        gaps.push_back({i, way / norm(way), gap, 1});
      }
    });
  }
  return gaps;
}

std::vector<flow::Sphere> cake() {
  const io::TextTable table = io::read_table(PF_SOURCE_DIR "/tests/data/plug.csv");
  const auto vectors = [&](const char* x, const char* y, const char* z, Real unit) {
    const auto a = table.numbers(x), b = table.numbers(y), c = table.numbers(z);
    std::vector<Vec3> out;
    for (std::size_t i = 0; i < a.size(); ++i) {
      out.push_back(unit * Vec3{a[i], b[i], c[i]});
    }
    return out;
  };
  const auto places = vectors("x_um", "y_um", "z_um", um);
  const auto forces = vectors("fx_pn", "fy_pn", "fz_pn", 1e-12);
  const auto torques = vectors("tx_pn_um", "ty_pn_um", "tz_pn_um", 1e-18);
  std::vector<flow::Sphere> spheres;
  for (std::size_t i = 0; i < places.size(); ++i) {
    spheres.push_back(sphere(i + 1, places[i], 5 * um));
    spheres.back().force = forces[i];
    spheres.back().torque = torques[i];
  }
  return spheres;
}

/// Every sphere as far back as it goes in `time`.
std::vector<flow::Sphere> earlier(std::vector<flow::Sphere> spheres,
                                  const std::vector<flow::SphereMotion>& motions, Real time) {
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    Vec3& x = spheres[i].position;
    x = x - time * motions[i].velocity;
    for (const int a : {1, 2}) {
      x[a] -= width * std::floor(x[a] / width);
    }
  }
  return spheres;
}

}  // namespace

/// Found: 20 to 25 cycles. While GCR went on from its last direction whatever it gained, such solves ended after 200 cycles
/// at residuals of 2e-4 to 4e-3.
TEST(Plug, warm_solves_do_not_stall) {
  flow::Boundaries ends;
  ends.kind[0] = ends.kind[1] = flow::FaceKind::pressure;
  const par::Communicator comm;
  flow::StokesSolver solver(comm, even_cut(cells, comm.size()), {cell, cell, cell}, ends, 1e-3);
  solver.set_surface(sieve);
  flow::Drive drive;
  drive.face_value[0] = 1200;
  const std::vector<flow::Sphere> spheres = cake();
  ASSERT_EQ(spheres.size(), 161U);
  for (const Real time : {2e-4, 4e-4, 2e-3, 3e-3}) {
    solver.forget();
    solver.set_spheres(spheres, gaps_of(spheres));
    EXPECT_TRUE(solver.solve(drive, to(1e-4)).converged);
    solver.set_spheres(earlier(spheres, solver.sphere_motions(), time));
    EXPECT_TRUE(solver.solve(drive, to(1e-4)).converged);
    solver.set_spheres(spheres, gaps_of(spheres));
    const flow::SolveReport report = solver.solve(drive, to(1e-4));
    std::printf("[ measured ] from %.1f ms before: %d cycles\n", 1e3 * time, report.cycles);
    EXPECT_TRUE(report.converged) << "residual " << report.residual;
    EXPECT_LE(report.cycles, 40);
  }
}

}  // namespace porefines::test
