// SPDX-License-Identifier: MPL-2.0
#include "mobility/known.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "mobility/box.hpp"

namespace porefines::mobility {
namespace {

using std::numbers::pi;

/// Places against the grid, in the plane of a wall.
constexpr std::array<Vec3, 2> on_wall{Vec3{0.13, 0.31, 0}, Vec3{0.62, 0.85, 0}};

/// Directions against the grid, of any length.
constexpr std::array<Vec3, 5> ways{
    Vec3{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {0.9, 0.4, 0.17}, {0.3, 0.8, 0.52}};

/// Solved afresh, without what the cells held before.
std::vector<flow::SphereMotion> solve(flow::StokesSolver& solver, const flow::Drive& drive,
                                      const std::vector<flow::Sphere>& spheres,
                                      const std::vector<flow::WallGap>& walls = {},
                                      Real tolerance = 1e-6) {
  solver.forget();
  solver.set_spheres(spheres, walls);
  const flow::SolveReport report = solver.solve(drive, to(tolerance));
  if (!report.converged) {
    throw RunError(fmt::format("{} spheres: residual {:.3g} after {} cycles", spheres.size(),
                               report.residual, report.cycles));
  }
  return solver.sphere_motions();
}

/// Two spheres of radius a in the middle of a box of n cells, their centres `distance` radii apart along `way`.
std::array<flow::Sphere, 2> pair_along(const Vec3& way, int n, Real a, Real distance) {
  const Vec3 middle{n / 2.0 + 0.13, n / 2.0 + 0.37, n / 2.0 - 0.21};
  const Vec3 half = (distance * a / 2) * way;
  return {sphere(1, middle - half, a), sphere(2, middle + half, a)};
}

/// A wall below, a lid above.
flow::Boundaries lid_along_z() {
  flow::Boundaries walls = slit_along_z();
  walls.kind[5] = flow::FaceKind::lid;
  return walls;
}

/// The lid of a box nz cells high makes a shear flow along x of this rate.
flow::Drive shear_flow(Real rate, int nz) {
  flow::Drive shear;
  shear.lid[5] = {rate * nz, 0, 0};
  return shear;
}

flow::WallGap floor_below(Real gap) {
  return {0, {0, 0, 1}, gap, 1};
}

}  // namespace

Real wall_factor(int size, Real height) {
  const Real a = size / 2.0;
  const bool is_near = height < 1.3;
  const int nx = (is_near ? 6 : 12) * size;
  flow::StokesSolver solver = open_box({nx, nx, (is_near ? 5 : 10) * size}, slit_along_z());
  const int places = is_near ? 10 : 2;
  Real mean = 0;
  for (int k = 1; k <= places; ++k) {
    // Roberts's sequence: evenly over the face of a cell
    const Vec3 offset{std::fmod(0.754877666 * k, 1.0), std::fmod(0.569840291 * k, 1.0), 0};
    flow::Sphere q = sphere(1, {nx / 2.0 + offset.x, nx / 2.0 + offset.y, height * a}, a);
    q.force = {0, 0, 1};
    const auto motion = solve(solver, {}, {q}, {floor_below((height - 1) * a)}).front();
    mean += 1 / (6 * pi * a * motion.velocity.z) / places;
  }
  return mean;
}

AlongWall along_wall(int size, Real height) {
  constexpr Real rate = 1e-2;
  const Real a = size / 2.0;
  const int nx = 14 * size;
  const int nz = 8 * size;
  flow::StokesSolver solver = open_box({nx, nx, nz}, lid_along_z());
  const flow::Drive still;
  const flow::Drive shear = shear_flow(rate, nz);
  AlongWall mean;
  for (const Vec3& offset : on_wall) {
    flow::Sphere q = sphere(1, {nx / 2.0 + offset.x, nx / 2.0 + offset.y, height * a}, a);
    const std::vector<flow::WallGap> below{floor_below((height - 1) * a)};
    const flow::SphereMotion free = solve(solver, shear, {q}, below).front();
    q.held = true;
    const flow::SphereMotion held = solve(solver, shear, {q}, below).front();
    q.velocity = {1, 0, 0};
    const flow::SphereMotion pulled = solve(solver, still, {q}, below).front();
    mean.drag += pulled.force.x / (-6 * pi * a) / 2;
    mean.force += held.force.x / (6 * pi * a * height * a * rate) / 2;
    mean.torque += held.torque.y / (4 * pi * a * a * a * rate) / 2;
    mean.speed += free.velocity.x / (height * a * rate) / 2;
    mean.spin += free.spin.y / (rate / 2) / 2;
  }
  return mean;
}

Real tube_speed(int size, Real ratio) {
  const Real tube = size / 2.0 / ratio;
  const int across = 2 * static_cast<int>(std::ceil(tube)) + 2;
  const int along = 6 * size;
  const Real centre = across / 2.0 + 0.11;
  const par::Communicator comm;
  const Int3 cells{along, across, across};
  flow::StokesSolver solver(comm, even_cut(cells, comm.size()), {1, 1, 1}, {}, 1.0);
  solver.set_surface([&](const Vec3& x) { return tube - std::hypot(x.y - centre, x.z - centre); });
  const flow::Sphere q = sphere(1, {along / 2.0 + 0.2, centre, centre}, size / 2.0);
  const auto motion = solve(solver, along_x(), {q}).front();
  // The mean gradient drives the sphere's own length as well.
  return motion.velocity.x / (tube * tube / 4);
}

Approach approach(int size, Real distance, Real exact) {
  const int n = (distance > 3 ? 16 : 8) * size;
  const Real a = size / 2.0;
  flow::StokesSolver solver = open_box({n, n, n}, {});
  Approach out;
  for (const Vec3& given : ways) {
    const Vec3 way = given / norm(given);
    auto [one, two] = pair_along(way, n, a, distance);
    one.force = way;
    two.force = Vec3{} - way;
    const auto m = solve(solver, {}, {one, two}, {}, 1e-5);
    const Real speed = dot(m[0].velocity - m[1].velocity, way) / 2;
    const Real found = 1 / (6 * pi * a * speed) / exact;
    out.mean += found / static_cast<Real>(ways.size());
    out.worst = std::max(out.worst, std::abs(found - 1));
  }
  return out;
}

Real together(int size, Real distance) {
  constexpr Real images = 2.837297;  // Hasimoto (1959), simple cubic
  const int n = 16 * size;
  const Real a = size / 2.0;
  const Real volume = static_cast<Real>(n) * n * n;
  flow::StokesSolver solver = open_box({n, n, n}, {});
  Real speed = 0;
  for (const Vec3& given : ways) {
    const Vec3 way = given / norm(given);
    auto [one, two] = pair_along(way, n, a, distance);
    one.force = two.force = way;
    flow::Drive back;  // what holds the box against both
    back.force = (-2 / volume) * way;
    const auto m = solve(solver, back, {one, two}, {}, 1e-5);
    const Vec3 mean = (m[0].velocity + m[1].velocity) / 2 - solver.superficial_velocity();
    speed += 6 * pi * a * dot(mean, way) / static_cast<Real>(ways.size());
  }
  return 1 / (speed + 2 * images * a / n);
}

Real turn_factor(int size) {
  const int n = 4 * size;
  const Real a = size / 2.0;
  flow::StokesSolver solver = open_box({n, n, n}, closed_box());
  Real mean = 0;
  for (const Vec3& offset : {Vec3{0.13, 0.30, 0.07}, {0.50, 0.51, -0.41}, {0.87, 0.72, 0.33}}) {
    flow::Sphere q = sphere(1, Vec3{n / 2.0, n / 2.0, n / 2.0} + offset, a);
    q.torque = {0, 1, 0};
    mean += solve(solver, {}, {q}).front().spin.y * 8 * pi * a * a * a / 3;
  }
  return mean;
}

Real shear_spin(int size) {
  constexpr Real rate = 1e-2;
  const int nx = 6 * size;
  const int nz = 8 * size;
  flow::StokesSolver solver = open_box({nx, nx, nz}, lid_along_z());
  const flow::Drive shear = shear_flow(rate, nz);
  const flow::Sphere q = sphere(1, {nx / 2.0 + 0.13, nx / 2.0 + 0.31, nz / 2.0 + 0.22}, size / 2.0);
  return solve(solver, shear, {q}).front().spin.y / (rate / 2);
}

Real intrinsic_viscosity(int size) {
  constexpr Real rate = 1e-2;
  const int n = 8 * size;
  const Real a = size / 2.0;
  flow::StokesSolver solver = open_box({n, n, n}, lid_along_z());
  const flow::Drive shear = shear_flow(rate, n);
  const flow::Sphere q = sphere(1, {n / 2.0 + 0.13, n / 2.0 + 0.31, n / 2.0 + 0.22}, a);
  solve(solver, shear, {q}, {}, 1e-7);
  const std::vector<float> along = solver.cell_fields().velocity[0];
  const std::size_t layer = static_cast<std::size_t>(n) * n;
  Real stress = 0;  // of the lid: half a cell above the last layer
  for (std::size_t i = along.size() - layer; i < along.size(); ++i) {
    stress += 2 * (rate * n - static_cast<Real>(along[i])) / static_cast<Real>(layer);
  }
  const Real share = 4 * pi / 3 * std::pow(a / n, 3);
  return (stress / rate - 1) / share;
}

}  // namespace porefines::mobility
