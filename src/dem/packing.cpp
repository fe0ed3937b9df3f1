// SPDX-License-Identifier: MPL-2.0
#include "dem/packing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/random.hpp"
#include "dem/relax.hpp"

namespace porefines::dem {
namespace {

bool touches_wall(const PackingSpace& space, const Vec3& x, Real radius) {
  TouchList touches;
  if (space.surfaces != nullptr) {
    find_touches(*space.surfaces, x, radius, 0, touches);
  }
  return touches.count > 0 || touches.inside;
}

/// Uniform over the space, outside of walls and grains: deep inside rock nothing would push a
/// sphere out again. Where a sphere finds no free place in 500 tries it stays at the last.
std::vector<Vec3> random_points(const PackingSpace& space, const std::vector<Real>& radius) {
  constexpr int tries = 500;
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < radius.size(); ++i) {
    Draws draws(space.seed, Stream::packing, i);
    Vec3 x;
    for (int t = 0; t == 0 || (t < tries && touches_wall(space, x, radius[i])); ++t) {
      for (int axis = 0; axis < 3; ++axis) {
        const Real wall = space.periodic[axis] ? 0 : radius[i];
        x[axis] = draws.uniform(space.low[axis] + wall, space.high[axis] - wall);
      }
    }
    points.push_back(x);
  }
  return points;
}

void require_room(const PackingSpace& space, const std::vector<Real>& radius) {
  if (radius.empty()) {
    throw InputError("a packing of no spheres");
  }
  const Real largest = 2 * *std::max_element(radius.begin(), radius.end());
  for (int axis = 0; axis < 3; ++axis) {
    const Real edge = space.high[axis] - space.low[axis];
    if (largest > edge) {
      throw InputError(
          fmt::format("spheres of up to {:.4g} m do not fit into a region of {:.4g} m along {}",
                      largest, edge, "xyz"[axis]));
    }
  }
}

Packing result(const Relaxation& at_rest, Real scale) {
  return {at_rest.position(),     at_rest.radius(),   scale,
          at_rest.mean_overlap(), at_rest.contacts(), at_rest.steps()};
}

}  // namespace

Real sphere_volume(Real radius) {
  return 4.0 / 3 * std::numbers::pi * radius * radius * radius;
}

Real sphere_volume(const std::vector<Real>& radius) {
  Real sum = 0;
  for (const Real r : radius) {
    sum += r * r * r;
  }
  return 4.0 / 3 * std::numbers::pi * sum;
}

Packing place_loose(const PackingSpace& space, const std::vector<Real>& radius) {
  constexpr Real margin = 1e-4;  // larger while they are pushed apart: then they do not even touch
  constexpr Index most = 5000;
  require_room(space, radius);
  std::vector<Real> larger = radius;
  for (Real& r : larger) {
    r *= 1 + margin;
  }
  Relaxation soft(space, random_points(space, radius), larger);
  (void)soft.minimise(0, most);
  if (soft.mean_overlap() > 1e-6) {
    throw InputError(
        fmt::format("{} spheres that take {:.3g} of their region could not be placed apart\n"
                    "try fewer or smaller ones, a larger region, or filling = \"dense\"",
                    radius.size(), sphere_volume(radius) / space.volume()));
  }
  Packing packing = result(soft, 1);
  packing.radius = radius;
  return packing;
}

Packing pack_dense(const PackingSpace& space, std::vector<Real> radius) {
  constexpr Real start = 0.66;     // above jamming
  constexpr Real wanted = 2.5e-4;  // overlap at the end
  constexpr Real enough = 2 * wanted;
  constexpr Real rough = 0.1;  // net force over contact force: on the way, and at the end
  constexpr Real at_rest = 0.01;
  constexpr Index most = 50'000;
  constexpr int rounds = 60;
  const Real first = std::cbrt(start * space.volume() / sphere_volume(radius));
  for (Real& r : radius) {
    r *= first;
  }
  require_room(space, radius);
  Relaxation soft(space, random_points(space, radius), radius);
  Real scale = first;
  Real jammed = 0;  // smallest scale found jammed
  Real loose = 0;   // largest found loose
  for (int round = 0; round < rounds; ++round) {
    (void)soft.minimise(rough, most);
    if (soft.mean_overlap() > 1e-7) {
      jammed = scale;
      if (soft.mean_overlap() <= enough && soft.minimise(at_rest, most) &&
          soft.mean_overlap() > 1e-7) {
        return result(soft, scale);
      }
    } else {
      loose = scale;
    }
    // Overlaps are nearly proportional to what the radii exceed those at jamming by.
    Real next = loose == 0 ? scale * (1 - (soft.mean_overlap() - wanted)) : 0.5 * (jammed + loose);
    if (loose > 0 && jammed - loose < 1e-5 * loose) {
      next = 1.002 * loose;  // it has found a denser arrangement: start again from above
      loose = 0;
    }
    soft.scale(next / scale);
    scale = next;
  }
  throw InputError(
      fmt::format("{} spheres found no packing at rest in {} m^3", radius.size(), space.volume()));
}

}  // namespace porefines::dem
