// SPDX-License-Identifier: MPL-2.0
// A periodic chip of round pillars with a suspension in it, in cells.
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "support/free_spheres.hpp"

namespace porefines::test {

struct CrowdedChip {
  int width = 0;  ///< cells along x and y
  int depth = 0;
  Real diameter = 6;
  std::vector<std::array<Real, 3>> pillars;  ///< x, y, radius
  std::vector<Vec3> spheres;                 ///< centres

  [[nodiscard]] Real wrapped(Real d) const { return d - width * std::round(d / width); }
  [[nodiscard]] Real distance(const Vec3& x) const {
    Real nearest = 1e30;
    for (const auto& [px, py, radius] : pillars) {
      nearest = std::min(nearest, std::hypot(wrapped(x.x - px), wrapped(x.y - py)) - radius);
    }
    return nearest;
  }
  /// Would a sphere fit here, all but `except` being where they are?
  [[nodiscard]] bool is_free(const Vec3& x, std::size_t except) const {
    const Real r = diameter / 2;
    bool free = x.z > r && x.z < depth - r && distance(x) > r;
    for (std::size_t k = 0; k < spheres.size() && free; ++k) {
      const Vec3 d{wrapped(x.x - spheres[k].x), wrapped(x.y - spheres[k].y), x.z - spheres[k].z};
      free = k == except || norm(d) > diameter;
    }
    return free;
  }
};

/// Nearly half of it pillars, then so many spheres of 6 cells at random.
inline CrowdedChip crowd_chip(int width, int depth, std::size_t count) {
  CrowdedChip chip;
  chip.width = width;
  chip.depth = depth;
  std::mt19937 numbers(7);
  const auto uniform = [&] { return std::generate_canonical<Real, 53>(numbers); };
  constexpr Real throat = 4;  // cells, at least
  Real area = 0;
  for (int tries = 0; tries < 200000 && area < 0.45 * width * width; ++tries) {
    const Real radius = 6 + 16 * uniform();
    const Vec3 x{uniform() * width, uniform() * width, 0};
    if (chip.distance(x) > radius + throat) {
      chip.pillars.push_back({x.x, x.y, radius});
      area += std::numbers::pi * radius * radius;
    }
  }
  for (int tries = 0; tries < 4000000 && chip.spheres.size() < count; ++tries) {
    const Vec3 x{uniform() * width, uniform() * width, uniform() * depth};
    if (chip.is_free(x, count)) {
      chip.spheres.push_back(x);
    }
  }
  return chip;
}

}  // namespace porefines::test
