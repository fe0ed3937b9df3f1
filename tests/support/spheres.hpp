// SPDX-License-Identifier: MPL-2.0
// Small systems of spheres: what unit, verification and MPI tests of the DEM share.
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "dem/system.hpp"

namespace porefines::test {

/// Settings for one species in a cube of side `side` whose low corner is the origin.
inline dem::Settings cube(Real side, bool periodic, const dem::Elastic& material,
                          const dem::Friction& friction) {
  dem::Settings s;
  s.box.high = {side, side, side};
  s.box.periodic = {periodic, periodic, periodic};
  s.materials = dem::MaterialTable({material}, friction);
  return s;
}

inline dem::Body sphere(std::uint64_t id, const Vec3& position, Real radius, Real density) {
  dem::Body b;
  b.id = id;
  b.position = position;
  b.radius = radius;
  b.density = density;
  return b;
}

/// Spheres on a jittered lattice that fills the cube, with random velocities; not touching.
/// Radii between `radius / spread` and `radius`.
inline std::vector<dem::Body> gas(int per_side, Real side, Real radius, Real spread, Real speed,
                                  unsigned seed) {
  std::mt19937_64 draw(seed);
  const auto uniform = [&draw] { return static_cast<Real>(draw() >> 11) * 0x1p-53; };
  const Real spacing = side / per_side;
  const Real jitter = std::max(0.0, spacing / 2 - radius);
  std::vector<dem::Body> bodies;
  for (int n = 0; n < per_side * per_side * per_side; ++n) {
    const Int3 cell{n % per_side, n / per_side % per_side, n / per_side / per_side};
    dem::Body b = sphere(static_cast<std::uint64_t>(n) + 1, {},
                         radius / (1 + (spread - 1) * uniform()), 1050);
    for (int a = 0; a < 3; ++a) {
      b.position[a] = (cell[a] + 0.5) * spacing + (2 * uniform() - 1) * jitter;
      b.velocity[a] = (2 * uniform() - 1) * speed;
      b.angular_velocity[a] = (2 * uniform() - 1) * speed / radius;
    }
    bodies.push_back(b);
  }
  return bodies;
}

/// Where particle `id` of this rank is; size() when it is elsewhere.
inline std::size_t find(const dem::Particles& p, std::uint64_t id) {
  std::size_t i = 0;
  while (i < p.owned && p.id[i] != id) {
    ++i;
  }
  return i < p.owned ? i : p.size();
}

inline const dem::Elastic latex{"latex", 5e6, 0.45};

}  // namespace porefines::test
