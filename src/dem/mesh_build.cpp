// SPDX-License-Identifier: MPL-2.0
#include <algorithm>
#include <map>
#include <unordered_map>

#include <fmt/format.h>

#include "core/error.hpp"
#include "dem/mesh.hpp"
#include "dem/mesh_cells.hpp"

namespace porefines::dem {

namespace {

using Point = std::array<float, 3>;

struct Hash {
  std::size_t operator()(const Point& p) const {
    std::size_t h = 0;
    for (const float v : p) {
      h = h * 1000003U + std::hash<float>()(v);
    }
    return h;
  }
};

void join_corners(const std::vector<geom::Triangle>& triangles, Mesh& mesh) {
  std::unordered_map<Point, std::int32_t, Hash> known;
  for (const geom::Triangle& triangle : triangles) {
    Mesh::Corners corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      Point p = triangle[k];
      for (float& v : p) {
        if (!std::isfinite(v)) {
          throw InputError(
              "a triangle of the mesh has a corner that is not a number; export it anew.");
        }
        v += 0.0F;  // -0 is 0
      }
      const auto [at, is_new] = known.emplace(p, static_cast<std::int32_t>(mesh.vertex.size()));
      if (is_new) {
        mesh.vertex.push_back({p[0], p[1], p[2]});
      }
      corners[k] = at->second;
    }
    const auto at = [&](std::size_t k) {
      return mesh.vertex[static_cast<std::size_t>(corners[k])];
    };
    const Vec3 area = cross(at(1) - at(0), at(2) - at(0));
    const Real longest = std::max({norm(at(1) - at(0)), norm(at(2) - at(1)), norm(at(0) - at(2))});
    if (norm(area) <= 1e-9 * longest * longest) {
      ++mesh.dropped;
      continue;
    }
    mesh.face.push_back(corners);
    mesh.normal.push_back(area / norm(area));
  }
  if (mesh.face.empty()) {
    throw InputError("the mesh has no triangle with an area; check the file and its unit.");
  }
}

void join_edges(Mesh& mesh) {
  std::map<std::pair<std::int32_t, std::int32_t>, std::pair<std::int32_t, int>> open;
  mesh.beside.assign(mesh.face.size(), {-1, -1, -1});
  for (std::size_t f = 0; f < mesh.face.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t a = mesh.face[f][k];
      const std::int32_t b = mesh.face[f][(k + 1) % 3];
      const auto other = open.find({b, a});
      if (other == open.end()) {
        open.insert_or_assign({a, b}, std::pair{static_cast<std::int32_t>(f), static_cast<int>(k)});
        continue;
      }
      mesh.beside[f][k] = other->second.first;
      mesh.beside[static_cast<std::size_t>(other->second.first)]
                 [static_cast<std::size_t>(other->second.second)] = static_cast<std::int32_t>(f);
      open.erase(other);
    }
  }
  mesh.closed = open.empty();
}

void list_around(Mesh& mesh) {
  mesh.first_around.assign(mesh.vertex.size() + 1, 0);
  for (const Mesh::Corners& face : mesh.face) {
    for (const std::int32_t v : face) {
      ++mesh.first_around[static_cast<std::size_t>(v) + 1];
    }
  }
  for (std::size_t v = 1; v < mesh.first_around.size(); ++v) {
    mesh.first_around[v] += mesh.first_around[v - 1];
  }
  mesh.around.resize(3 * mesh.face.size());
  auto next = mesh.first_around;
  for (std::size_t f = 0; f < mesh.face.size(); ++f) {
    for (const std::int32_t v : mesh.face[f]) {
      mesh.around[static_cast<std::size_t>(next[static_cast<std::size_t>(v)]++)] =
          static_cast<std::int32_t>(f);
    }
  }
}

void fill_cells(Mesh& mesh, Real largest) {
  Vec3 high = mesh.vertex[0];
  mesh.low = high;
  for (const Vec3& v : mesh.vertex) {
    for (int a = 0; a < 3; ++a) {
      mesh.low[a] = std::min(mesh.low[a], v[a]);
      high[a] = std::max(high[a], v[a]);
    }
  }
  const Vec3 size = high - mesh.low;
  Real length = 0;
  for (std::size_t f = 0; f < mesh.face.size(); ++f) {
    const CellBox box = face_box(mesh, f);
    length += norm(box.high - box.low);
  }
  length /= static_cast<Real>(mesh.face.size());
  mesh.cell = std::max(length, 0.5 * largest);
  const Real most = 4.0 * static_cast<Real>(mesh.face.size()) + 64;
  for (bool too_many = true; too_many; mesh.cell *= too_many ? 1.3 : 1.0) {
    Real count = 1;
    for (int a = 0; a < 3; ++a) {
      mesh.cells[static_cast<std::size_t>(a)] =
          1 + static_cast<int>(std::min(size[a] / mesh.cell, 1e6));
      count *= mesh.cells[static_cast<std::size_t>(a)];
    }
    too_many = count > most;
  }
  for (std::size_t f = 0; f < mesh.face.size(); ++f) {
    const CellBox box = face_box(mesh, f);
    mesh.first_cell.push_back(cells_of(mesh, box).low);
    mesh.middle.push_back(0.5 * (box.low + box.high));
    mesh.extent.push_back(0.5 * norm(box.high - box.low));
  }
  mesh.start.assign(static_cast<std::size_t>(product(mesh.cells)) + 1, 0);
  const auto for_cells = [&](const auto& visit) {
    for (std::size_t f = 0; f < mesh.face.size(); ++f) {
      const CellRange range = cells_of(mesh, face_box(mesh, f));
      range.for_each([&](const Int3& c) { visit(f, cell_index(mesh, c)); });
    }
  };
  for_cells([&](std::size_t, std::size_t c) { ++mesh.start[c + 1]; });
  for (std::size_t c = 1; c < mesh.start.size(); ++c) {
    mesh.start[c] += mesh.start[c - 1];
  }
  mesh.list.resize(static_cast<std::size_t>(mesh.start.back()));
  auto next = mesh.start;
  for_cells([&](std::size_t f, std::size_t c) {
    mesh.list[static_cast<std::size_t>(next[c]++)] = static_cast<std::int32_t>(f);
  });
}

}  // namespace

Mesh make_mesh(const std::vector<geom::Triangle>& triangles, Real largest) {
  Mesh mesh;
  join_corners(triangles, mesh);
  join_edges(mesh);
  list_around(mesh);
  fill_cells(mesh, largest);
  return mesh;
}

}  // namespace porefines::dem
