// SPDX-License-Identifier: MPL-2.0
#include "mobility/box.hpp"

namespace porefines::mobility {

using flow::FaceKind;

par::Decomposition even_cut(const Int3& cells, int ranks) {
  par::LayerWork work;
  for (int a = 0; a < 3; ++a) {
    work[a].assign(static_cast<std::size_t>(cells[a]), 1.0);
  }
  return par::decompose(cells, ranks, work);
}

flow::StokesSolver open_box(const Int3& cells, const flow::Boundaries& boundaries,
                            const par::Communicator& comm) {
  flow::StokesSolver solver(comm, even_cut(cells, comm.size()), {1, 1, 1}, boundaries, 1.0);
  solver.set_surface([](const Vec3&) { return 1e3; });
  return solver;
}

flow::Boundaries slit_along_z() {
  flow::Boundaries walls;
  walls.kind[4] = walls.kind[5] = FaceKind::wall;
  return walls;
}

flow::Boundaries closed_box() {
  flow::Boundaries walls;
  walls.kind.fill(FaceKind::wall);
  return walls;
}

flow::Sphere sphere(std::uint64_t id, const Vec3& position, Real radius) {
  flow::Sphere q;
  q.id = id;
  q.position = position;
  q.radius = radius;
  return q;
}

flow::Drive along_x() {
  flow::Drive drive;
  drive.force = {1, 0, 0};
  return drive;
}

flow::SolveOptions to(Real tolerance) {
  flow::SolveOptions options;
  options.tolerance = tolerance;
  return options;
}

}  // namespace porefines::mobility
