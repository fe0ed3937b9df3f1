// SPDX-License-Identifier: MPL-2.0
#include "geom/stl.hpp"

#include <algorithm>
#include <cstring>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "geom/triangulate.hpp"

namespace porefines::geom {

namespace {

using Vertex = std::array<float, 3>;

Vertex vertex(const Point2& p, Real z) {
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(z)};
}

/// Values on the voxel centres with a layer of pore around the box; that layer stands on the
/// box faces, so the surface closes there.
struct Lattice {
  const VoxelSolid& solid;

  [[nodiscard]] Real value(const Int3& i) const {
    for (std::size_t a = 0; a < 3; ++a) {
      if (i[a] < 0 || i[a] >= solid.n[a]) {
        return 0.02;
      }
    }
    const auto s = static_cast<Real>(
        solid.s[static_cast<std::size_t>(voxel_index(solid.n, i[0], i[1], i[2]))]);
    return std::abs(s) < 1e-3 ? (s < 0 ? -1e-3 : 1e-3) : s;
  }
  [[nodiscard]] Real coordinate(const Int3& i, std::size_t axis) const {
    return std::clamp<Real>(i[axis] + 0.5, 0, solid.n[axis]) * solid.pixel;
  }
};

/// Point with s = 0 between two lattice points; the same bits whichever comes first.
Vertex crossing(const Lattice& lattice, Int3 p, Int3 q) {
  if (q < p) {
    std::swap(p, q);
  }
  const Real a = lattice.value(p);
  const Real b = lattice.value(q);
  const Real t = std::clamp<Real>(a / (a - b), 0.02, 0.98);
  Vertex out{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Real x = lattice.coordinate(p, axis);
    out[axis] = static_cast<float>(x + t * (lattice.coordinate(q, axis) - x));
  }
  return out;
}

/// Corners of the six tetrahedra around the diagonal 0-7 of a cube, positively oriented;
/// bit 0, 1, 2 of a corner is its x, y, z.
constexpr std::array<std::array<int, 4>, 6> tetrahedra{
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

/// Triangles of one tetrahedron, facing the pore.
void march(const Lattice& lattice, const std::array<Int3, 4>& corner, std::vector<Triangle>& out) {
  std::array<std::size_t, 4> grain{};
  std::array<std::size_t, 4> pore{};
  std::size_t grains = 0;
  std::size_t pores = 0;
  for (std::size_t c = 0; c < 4; ++c) {
    if (lattice.value(corner[c]) < 0) {
      grain[grains++] = c;
    } else {
      pore[pores++] = c;
    }
  }
  if (grains == 0 || pores == 0) {
    return;
  }
  const auto cut = [&](std::size_t g, std::size_t p) {
    return crossing(lattice, corner[g], corner[p]);
  };
  // parity of the order (grain corners, pore corners) tells which way the triangle faces
  std::array<std::size_t, 4> order{};
  std::copy_n(grain.begin(), grains, order.begin());
  std::copy_n(pore.begin(), pores, order.begin() + static_cast<std::ptrdiff_t>(grains));
  bool odd = false;
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = a + 1; b < 4; ++b) {
      odd = odd != (order[a] > order[b]);
    }
  }
  const auto add = [&](const Vertex& a, const Vertex& b, const Vertex& c) {
    out.push_back(odd ? Triangle{a, c, b} : Triangle{a, b, c});
  };
  if (grains == 1) {
    add(cut(grain[0], pore[0]), cut(grain[0], pore[1]), cut(grain[0], pore[2]));
  } else if (grains == 3) {
    add(cut(grain[0], pore[0]), cut(grain[1], pore[0]), cut(grain[2], pore[0]));
  } else {
    const Vertex a = cut(grain[0], pore[0]);
    const Vertex b = cut(grain[0], pore[1]);
    const Vertex c = cut(grain[1], pore[1]);
    const Vertex d = cut(grain[1], pore[0]);
    add(a, b, c);
    add(a, c, d);
  }
}

}  // namespace

std::vector<Triangle> extrude(const std::vector<Outline>& outlines, Real depth) {
  std::vector<Triangle> out;
  const auto point = [&](const Corner& c) -> const Point2& {
    return outlines[static_cast<std::size_t>(c.outline)][static_cast<std::size_t>(c.place)];
  };
  for (const auto& [a, b, c] : triangulate(outlines)) {
    out.push_back({vertex(point(a), depth), vertex(point(b), depth), vertex(point(c), depth)});
    out.push_back({vertex(point(a), 0), vertex(point(c), 0), vertex(point(b), 0)});
  }
  for (const Outline& outline : outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Point2& p = outline[i];
      const Point2& q = outline[(i + 1) % outline.size()];
      out.push_back({vertex(p, 0), vertex(q, 0), vertex(q, depth)});
      out.push_back({vertex(p, 0), vertex(q, depth), vertex(p, depth)});
    }
  }
  return out;
}

namespace {

/// The six tetrahedra of the cube whose lowest corner is `low`.
void march_cube(const Lattice& lattice, const Int3& low, std::vector<Triangle>& out) {
  std::array<Int3, 8> cube{};
  int grains = 0;
  for (int c = 0; c < 8; ++c) {
    const auto u = static_cast<std::size_t>(c);
    cube[u] = {low[0] + (c & 1), low[1] + (c >> 1 & 1), low[2] + (c >> 2)};
    grains += lattice.value(cube[u]) < 0 ? 1 : 0;
  }
  if (grains == 0 || grains == 8) {
    return;
  }
  for (const auto& t : tetrahedra) {
    march(lattice,
          {cube[static_cast<std::size_t>(t[0])], cube[static_cast<std::size_t>(t[1])],
           cube[static_cast<std::size_t>(t[2])], cube[static_cast<std::size_t>(t[3])]},
          out);
  }
}

}  // namespace

std::vector<Triangle> grain_surface(const VoxelSolid& solid) {
  if (solid.n[2] == 1 || solid.window.size() != solid.n) {
    throw RunError("grain_surface needs the solid of a whole 3D image");
  }
  const Lattice lattice{solid};
  std::vector<Triangle> out;
  for (int k = -1; k < solid.n[2]; ++k) {
    for (int j = -1; j < solid.n[1]; ++j) {
      for (int i = -1; i < solid.n[0]; ++i) {
        march_cube(lattice, {i, j, k}, out);
      }
    }
  }
  return out;
}

void write_stl(const std::string& path, const std::vector<Triangle>& triangles) {
  std::string bytes(84, '\0');
  const std::string title = "porefines: grain surface, lengths in metres";
  std::copy(title.begin(), title.end(), bytes.begin());
  const auto count = static_cast<std::uint32_t>(triangles.size());
  std::memcpy(&bytes[80], &count, sizeof count);
  AtomicFile file(path);
  for (const Triangle& t : triangles) {
    Vec3 u;
    Vec3 v;
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      u[axis] = Real{t[1][a]} - t[0][a];
      v[axis] = Real{t[2][a]} - t[0][a];
    }
    Vec3 n = cross(u, v);
    n = norm(n) > 0 ? n / norm(n) : n;
    std::array<char, 50> record{};
    const std::array<float, 3> normal{static_cast<float>(n.x), static_cast<float>(n.y),
                                      static_cast<float>(n.z)};
    std::memcpy(record.data(), normal.data(), 12);
    std::memcpy(record.data() + 12, t.data(), 36);
    bytes.append(record.data(), record.size());
    if (bytes.size() > std::size_t{1} << 20) {
      file.write(bytes);
      bytes.clear();
    }
  }
  file.write(bytes);
  file.commit();
}

Real enclosed_volume(const std::vector<Triangle>& triangles) {
  Real six = 0;
  const auto at = [](const Vertex& v) { return Vec3{v[0], v[1], v[2]}; };
  for (const auto& [a, b, c] : triangles) {
    six += dot(at(a), cross(at(b), at(c)));
  }
  return six / 6;
}

}  // namespace porefines::geom
