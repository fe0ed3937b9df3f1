// SPDX-License-Identifier: MPL-2.0
#include "media.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "geom/round_bodies.hpp"

namespace porefines::bench {
namespace {

constexpr Real micron = 1e-6;

struct Disc {
  Real x, y, radius;  ///< [cells]
};

// clang-format off
constexpr auto discs = std::to_array<Disc>({
    {35.4, 9.6, 15.2}, {34.9, 55.4, 15.2}, {39.5, 105.8, 17.2}, {35.3, 150.2, 14.5},
    {35, 193.6, 14.2}, {39.6, 244, 17.4}, {38.8, 286.2, 14.7}, {84.3, 36.4, 17.7},
    {85.8, 78.5, 16.3}, {84.5, 127, 14}, {83.3, 170.5, 18.1}, {85.7, 219.3, 14.7},
    {86, 265.4, 17.9}, {129.5, 12.6, 15.4}, {128, 56.8, 17.5}, {127.3, 101.3, 16.4},
    {128.7, 150.2, 15.6}, {129.1, 199, 14.1}, {129.5, 240.2, 16.5}, {128.7, 287.1, 17.1},
    {175.4, 35.4, 18}, {174.1, 78.4, 14.3}, {178.1, 127.7, 14.3}, {175.5, 171.1, 15.5},
    {173.8, 220.2, 17.9}, {179.2, 266.4, 18.3}, {173.6, 309.7, 18.3}, {224.7, 11.5, 18.2},
    {223.7, 59.9, 14.6}, {221.1, 103.7, 13.8}, {222.3, 152.8, 14.8}, {220.1, 193.3, 13.9},
    {224.7, 241.2, 14.6}, {220.6, 290.9, 15.3}, {267.7, 32.4, 13.3}, {267.5, 82.1, 13.8},
    {266.7, 126.9, 14.4}, {272.5, 170.7, 15.9}, {271.1, 218.5, 18.4}, {269.4, 263.5, 15.3},
    {314.5, 14.3, 17.6}, {316, 55.2, 14.4}, {314.5, 102.2, 14.3}, {318.2, 147.9, 13.3},
    {318.6, 196.4, 18.4}, {315.4, 244.4, 16.6}, {317.7, 289.5, 15.7}, {360.1, 33.3, 17.8},
    {364.9, 83.5, 14.9}, {363.4, 128.8, 16.5}, {364.4, 173.2, 16.6}, {363.6, 217.6, 18.1},
    {365.2, 262.4, 18.3},
});
// clang-format on

Medium make_sphere_array() {
  constexpr int n = 128;
  constexpr int spheres = 4;
  constexpr Real pitch = n / spheres * micron;
  Medium m;
  m.name = "spheres_128x128x128";
  m.cells = {n, n, n};
  m.spacing = {micron, micron, micron};
  m.drive.force = {1, 0, 0};
  m.distance = [](const Vec3& at) {
    const auto from_centre = [](Real x) { return x - (std::floor(x / pitch) + 0.5) * pitch; };
    return norm(Vec3{from_centre(at.x), from_centre(at.y), from_centre(at.z)}) - 0.45 * pitch;
  };
  return m;
}

Medium make_micromodel() {
  constexpr Real cell = 2 * micron;
  Medium m;
  m.name = "micromodel_400x300x16";
  m.cells = {400, 300, 16};
  m.spacing = {cell, cell, cell};
  using flow::FaceKind;
  m.boundaries.kind = {FaceKind::pressure, FaceKind::pressure, FaceKind::slip,
                       FaceKind::slip,     FaceKind::wall,     FaceKind::wall};
  m.drive.face_value[0] = 10;
  std::vector<geom::Body> bodies;
  for (const Disc& d : discs) {
    bodies.push_back({{d.x * cell, d.y * cell, 0}, d.radius * cell});
  }
  const Vec3 size{m.cells[0] * cell, m.cells[1] * cell, m.cells[2] * cell};
  const auto grains =
      std::make_shared<geom::CylinderList>(bodies, geom::SampleBox{size}, false, 3 * cell);
  m.distance = [grains](const Vec3& at) { return grains->signed_distance(at); };
  return m;
}

Medium make_small_box() {
  Medium m;
  m.name = "box_28x20x20";
  m.cells = {28, 20, 20};
  m.spacing = {micron, micron, micron};
  m.boundaries.kind.fill(flow::FaceKind::wall);
  m.boundaries.kind[0] = m.boundaries.kind[1] = flow::FaceKind::pressure;
  m.drive.face_value[0] = 1;
  m.distance = [](const Vec3&) { return 3 * micron; };
  m.shared = false;
  return m;
}

std::map<std::string, std::unique_ptr<flow::StokesSolver>>& solvers() {
  static std::map<std::string, std::unique_ptr<flow::StokesSolver>> kept;
  return kept;
}

}  // namespace

const Medium& sphere_array() {
  static const Medium medium = make_sphere_array();
  return medium;
}

const Medium& micromodel() {
  static const Medium medium = make_micromodel();
  return medium;
}

const Medium& small_box() {
  static const Medium medium = make_small_box();
  return medium;
}

par::Decomposition cut(const Medium& medium, int ranks) {
  par::LayerWork work;
  for (int a = 0; a < 3; ++a) {
    work[a].assign(static_cast<std::size_t>(medium.cells[a]), 1.0);
  }
  return par::decompose(medium.cells, ranks, work);
}

flow::StokesSolver& prepared(const Medium& medium) {
  auto& solver = solvers()[medium.name];
  if (!solver) {
    const auto comm = medium.shared ? par::Communicator() : par::Communicator::self();
    solver = std::make_unique<flow::StokesSolver>(comm, cut(medium, comm.size()), medium.spacing,
                                                  medium.boundaries, viscosity);
    solver->set_surface(medium.distance);
    flow::SolveOptions few;  // right-hand side and unknowns of ordinary size
    few.max_cycles = 2;
    solver->solve(medium.drive, few);
  }
  return *solver;
}

void forget_solvers() {
  solvers().clear();
}

}  // namespace porefines::bench
