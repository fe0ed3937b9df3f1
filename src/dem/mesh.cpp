// SPDX-License-Identifier: MPL-2.0
#include "dem/mesh.hpp"

#include <algorithm>

#include "dem/mesh_cells.hpp"
#include "dem/surface_foot.hpp"

namespace porefines::dem {

namespace {

/// Nearest point of a triangle and where it is: corners with weight.
struct Nearest {
  Vec3 at;
  std::array<bool, 3> on{};  ///< which corners take part: 3 face, 2 edge, 1 vertex
};

/// Ref: Ericson, Real-Time Collision Detection (2005), section 5.1.5.
Nearest nearest_point(const Mesh& mesh, std::size_t face, const Vec3& p) {
  const Vec3& a = corner(mesh, face, 0);
  const Vec3& b = corner(mesh, face, 1);
  const Vec3& c = corner(mesh, face, 2);
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Real d1 = dot(ab, p - a);
  const Real d2 = dot(ac, p - a);
  if (d1 <= 0 && d2 <= 0) {
    return {a, {true, false, false}};
  }
  const Real d3 = dot(ab, p - b);
  const Real d4 = dot(ac, p - b);
  if (d3 >= 0 && d4 <= d3) {
    return {b, {false, true, false}};
  }
  const Real vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    return {a + (d1 / (d1 - d3)) * ab, {true, true, false}};
  }
  const Real d5 = dot(ab, p - c);
  const Real d6 = dot(ac, p - c);
  if (d6 >= 0 && d5 <= d6) {
    return {c, {false, false, true}};
  }
  const Real vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    return {a + (d2 / (d2 - d6)) * ac, {true, false, true}};
  }
  const Real va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    return {b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b), {false, true, true}};
  }
  return {a + (vb / (va + vb + vc)) * ab + (vc / (va + vb + vc)) * ac, {true, true, true}};
}

/// Whether a triangle that shares the point comes nearer to c: then it is no minimum.
/// @param out  mean normal of the triangles that share it
bool is_minimum(const Mesh& mesh, std::size_t face, const Nearest& near, const Vec3& c, Real radius,
                Vec3& out) {
  out = mesh.normal[face];
  const int corners = near.on[0] + near.on[1] + near.on[2];
  const Real least = norm(c - near.at) - 1e-12 * radius;
  const auto is_nearer = [&](std::int32_t other) {
    const auto f = static_cast<std::size_t>(other);
    if (other < 0 || f == face) {
      return false;
    }
    out += mesh.normal[f];
    return norm(c - nearest_point(mesh, f, c).at) < least;
  };
  if (corners == 2) {
    const std::size_t k = near.on[0] && near.on[1] ? 0 : near.on[1] ? 1 : 2;
    return !is_nearer(mesh.beside[face][k]);
  }
  if (corners == 1) {
    const std::size_t k = near.on[0] ? 0 : near.on[1] ? 1 : 2;
    const auto v = static_cast<std::size_t>(mesh.face[face][k]);
    for (auto i = mesh.first_around[v]; i < mesh.first_around[v + 1]; ++i) {
      if (is_nearer(mesh.around[static_cast<std::size_t>(i)])) {
        return false;
      }
    }
  }
  return true;
}

/// Overlap where the planes of two faces meet, on the arc between their feet: along d the planes are
/// a/(d.n_a) and b/(d.n_b) away, equal for d = (1 - t) n_a + t n_b with t as below.
Real overlap_at_edge(const Foot& a, const Foot& b, Real radius) {
  const Real cosine = dot(a.normal, b.normal);
  const Real to_b = b.distance - cosine * a.distance;
  const Real to_a = a.distance - cosine * b.distance;
  if (to_a <= 0 || to_b <= 0) {  // the edge is not between the feet: the shallower counts
    return radius - std::max(a.distance, b.distance);
  }
  const Real t = to_b / (to_a + to_b);
  const Vec3 towards = (1 - t) * a.normal + t * b.normal;
  return radius - a.distance * norm(towards) / dot(towards, a.normal);
}

/// Faces near a sphere, each once: in the first of the cells that both meet.
template <class Visit>
void for_each_near(const Mesh& mesh, const Vec3& c, Real within, const Visit& visit) {
  const Vec3 reach{within, within, within};
  const CellRange range = cells_of(mesh, {c - reach, c + reach});
  range.for_each([&](const Int3& cell) {
    const std::size_t at = cell_index(mesh, cell);
    for (auto e = mesh.start[at]; e < mesh.start[at + 1]; ++e) {
      const auto f = static_cast<std::size_t>(mesh.list[static_cast<std::size_t>(e)]);
      const Vec3 to_middle = c - mesh.middle[f];
      const Real far = within + mesh.extent[f];
      if (dot(to_middle, to_middle) >= far * far) {
        continue;
      }
      bool is_first = true;
      for (std::size_t a = 0; a < 3; ++a) {
        is_first = is_first && cell[a] == std::max(mesh.first_cell[f][a], range.low[a]);
      }
      if (is_first) {
        visit(f);
      }
    }
  });
}

struct Feet {
  std::array<Foot, 2 * TouchList::capacity> foot;
  std::size_t count = 0;
  int lost = 0;
};

void add_foot(const Mesh& mesh, std::size_t face, const Vec3& c, Real radius, Real within,
              Feet& feet) {
  const Nearest near = nearest_point(mesh, face, c);
  const Vec3 away = c - near.at;
  const Real distance = norm(away);
  Vec3 outward;
  if (distance >= within || !is_minimum(mesh, face, near, c, radius, outward)) {
    return;
  }
  for (std::size_t f = 0; f < feet.count; ++f) {
    if (norm(feet.foot[f].at - near.at) < 1e-5 * radius) {
      return;
    }
  }
  if (feet.count == feet.foot.size()) {
    ++feet.lost;
    return;
  }
  const bool is_behind = mesh.closed && dot(away, outward) < 0;
  const Vec3 normal =
      distance > 1e-12 * radius ? (is_behind ? -1 : 1) / distance * away : mesh.normal[face];
  feet.foot[feet.count++] = {near.at, normal, is_behind ? -distance : distance, 1, true};
}

}  // namespace

void find_touches(const Mesh& mesh, const Vec3& centre, Real radius, Real reach, TouchList& out) {
  const Real within = radius + reach;
  Feet feet;
  for_each_near(mesh, centre, within,
                [&](std::size_t f) { add_foot(mesh, f, centre, radius, within, feet); });
  out.lost += feet.lost;
  const std::span<Foot> found = keep_near_side({feet.foot.data(), feet.count}, within);
  if (found.size() > 1) {
    share_force(found, radius,
                [&](const Foot& a, const Foot& b) { return overlap_at_edge(a, b, radius); });
  }
  for (const Foot& foot : found) {
    out.inside = out.inside || foot.distance <= 0;
    out.add({foot.normal, foot.distance - radius, {}, 0, foot.share, 0});
  }
}

}  // namespace porefines::dem
