// SPDX-License-Identifier: MPL-2.0
// Moves the spheres of a LIGGGHTS data file through the same case and prints how fast.
//   dem_speed FILE periodic|settling|PORE.pgm STEPS WARM
// PORE.pgm: 1 um a pixel, 0 = pore, grains 16 um high between plates.
#include <chrono>
#include <ctime>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

#include <fmt/format.h>

#include "core/error.hpp"
#include "dem/system.hpp"
#include "geom/voxel_solid.hpp"
#include "par/mpi_defaults.hpp"

using namespace porefines;

namespace {

struct Case {
  dem::Box box;
  std::vector<dem::Body> bodies;
};

/// Reads box, "Atoms" (id type diameter density x y z) and "Velocities" (id v w).
Case read(const std::string& name) {
  std::ifstream file(name);
  if (!file) {
    throw InputError("cannot read " + name);
  }
  Case c;
  bool velocities = false;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    velocities = velocities || line == "Velocities";
    Real low = 0, high = 0;
    std::string what;
    for (int a = 0; a < 3; ++a) {
      const std::string tag{"xyz"[a], 'l', 'o'};
      if (line.find(tag) != std::string::npos && words >> low >> high) {
        c.box.low[a] = low, c.box.high[a] = high;
      }
    }
    std::istringstream row(line);
    dem::Body b;
    int type = 0;
    if (!velocities && row >> b.id >> type >> b.radius >> b.density >> b.position.x >>
                           b.position.y >> b.position.z) {
      b.radius /= 2;
      c.bodies.push_back(b);
    } else if (std::istringstream v(line);
               velocities && v >> b.id >> b.velocity.x >> b.velocity.y >> b.velocity.z) {
      c.bodies[b.id - 1].velocity = b.velocity;
    }
  }
  return c;
}

/// Grains of the picture as a signed distance, plates and the picture's border as planes.
dem::Surfaces pore_walls(const std::string& name, Real largest) {
  std::ifstream file(name, std::ios::binary);
  std::string magic;
  Int3 n{0, 0, 1};
  int most = 0;
  file >> magic >> n[0] >> n[1] >> most;
  file.get();
  std::vector<char> pixels(static_cast<std::size_t>(product(n)));
  if (magic != "P5" || !file.read(pixels.data(), static_cast<std::streamsize>(pixels.size()))) {
    throw InputError("cannot read " + name);
  }
  geom::Voxels voxels = geom::make_voxels(n, 0);
  for (int j = 0; j < n[1]; ++j) {
    for (int i = 0; i < n[0]; ++i) {
      voxels.at(i, j, 0) = pixels[static_cast<std::size_t>(i + n[0] * j)] == 0 ? 1 : 0;
    }
  }
  constexpr geom::Surroundings mirrored{geom::Beyond::mirror, geom::Beyond::mirror,
                                        geom::Beyond::mirror};
  const geom::Window window{{-12, -12, 0}, {n[0] + 12, n[1] + 12, 1}};
  const auto solid = geom::smooth_solid(voxels.view(), 1e-6, mirrored, window, {1, 8});
  const Vec3 high{n[0] * 1e-6, n[1] * 1e-6, 16e-6};
  return {dem::Fixed<dem::DistanceField>(dem::make_field(solid, largest)),
          dem::box_faces({}, high, {true, true, true, true, true, true})};
}

Real cpu_seconds() {
  return static_cast<Real>(std::clock()) / CLOCKS_PER_SEC;
}

void run(const par::Communicator& comm, const std::string& file, const std::string& kind,
         Index steps, Index warm) {
  const Case c = read(file);
  dem::Settings s;
  s.box = c.box;
  const bool settling = kind == "settling";
  const bool pore = !settling && kind != "periodic";
  s.box.periodic = {!pore, !pore, !pore && !settling};
  s.materials = dem::MaterialTable({{"latex", 5e6, 0.45}}, {0.9, 0.5});
  if (settling) {
    s.gravity = {0, 0, -2000};
    s.walls.emplace_back(
        dem::box_faces(s.box.low, s.box.high, {false, false, false, false, true, true}));
  }
  if (pore) {
    s.gravity = {2000 * 0.957826, 0, -2000 * 0.287348};  // along (1, 0, -0.3)
    s.walls = pore_walls(kind, 5e-6);
  }
  dem::System system(comm, s);
  system.insert(c.bodies);
  constexpr Real dt = 2e-8;
  system.advance(dt, warm);
  const auto before = system.work();
  const auto start = std::chrono::steady_clock::now();
  const Real cpu = cpu_seconds();
  system.advance(dt, steps);
  const Real mine = cpu_seconds() - cpu;
  const std::chrono::duration<Real> wall = std::chrono::steady_clock::now() - start;
  const Real busiest = comm.max(mine);
  const auto totals = system.totals();
  const Real overlap = system.largest_overlap();
  const Real moved = static_cast<Real>(steps) * static_cast<Real>(totals.particles);
  if (comm.is_root()) {
    fmt::print(
        "porefines {} particles, {} rank(s): {:.1f} M particle-steps/s of CPU of the busiest rank, "
        "{:.1f} by the clock; {:.2f} contacts per particle, kinetic {:.4g} J, {} rebuilds, {} "
        "narrowings, {} listed pairs, largest overlap {:.4f} r\n",
        totals.particles, comm.size(), moved / busiest * 1e-6, moved / wall.count() * 1e-6,
        static_cast<Real>(totals.contacts) / static_cast<Real>(totals.particles), totals.kinetic,
        system.work().rebuilds - before.rebuilds, system.work().narrowings - before.narrowings,
        system.work().listed_pairs, overlap);
  }
}

}  // namespace

int main(int argc, char** argv) {
  par::set_mpi_defaults();
  MPI_Init(&argc, &argv);
  int status = 0;
  try {
    if (argc != 5) {
      throw InputError("usage: dem_speed FILE periodic|settling|PORE.pgm STEPS WARM");
    }
    run(par::Communicator(), argv[1], argv[2], std::stoll(argv[3]), std::stoll(argv[4]));
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    status = exit_code::wrong_input;
  }
  MPI_Finalize();
  return status;
}
