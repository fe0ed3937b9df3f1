// SPDX-License-Identifier: MPL-2.0
// Triangle meshes of simple shapes; normals point away from the solid.
#pragma once

#include <numbers>
#include <vector>

#include "geom/stl.hpp"

namespace porefines::test {

inline std::array<float, 3> to_float(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// Parallelogram p, p + u, p + u + v, p + v; the normal is along u x v.
inline std::vector<geom::Triangle> quad(const Vec3& p, const Vec3& u, const Vec3& v) {
  return {{to_float(p), to_float(p + u), to_float(p + u + v)},
          {to_float(p), to_float(p + u + v), to_float(p + v)}};
}

inline std::vector<geom::Triangle> turned(std::vector<geom::Triangle> triangles) {
  for (geom::Triangle& t : triangles) {
    std::swap(t[1], t[2]);
  }
  return triangles;
}

inline std::vector<geom::Triangle> box_mesh(const Vec3& low, const Vec3& high, bool hollow) {
  const Vec3 x{high.x - low.x, 0, 0};
  const Vec3 y{0, high.y - low.y, 0};
  const Vec3 z{0, 0, high.z - low.z};
  std::vector<geom::Triangle> out;
  for (const auto& face : {quad(low, y, x), quad(low, x, z), quad(low, z, y), quad(low + z, x, y),
                           quad(low + y, z, x), quad(low + x, y, z)}) {
    out.insert(out.end(), face.begin(), face.end());
  }
  return hollow ? turned(out) : out;
}

/// Sphere of 2 n (n - 1) facets pairs by latitude and longitude.
inline std::vector<geom::Triangle> ball_mesh(const Vec3& centre, Real radius, int n, bool hollow) {
  const auto at = [&](int i, int j) {
    const Real theta = std::numbers::pi * j / n;
    const Real phi = std::numbers::pi * (i % (2 * n)) / n;
    const Real ring = j == 0 || j == n ? 0 : std::sin(theta);
    return to_float(centre + radius * Vec3{ring * std::cos(phi), ring * std::sin(phi),
                                           j == n ? -1 : std::cos(theta)});
  };
  std::vector<geom::Triangle> out;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < 2 * n; ++i) {
      if (j < n - 1) {
        out.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      }
      if (j > 0) {
        out.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
      }
    }
  }
  return hollow ? turned(out) : out;
}

}  // namespace porefines::test
