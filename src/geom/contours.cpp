// SPDX-License-Identifier: MPL-2.0
#include "geom/contours.hpp"

#include <algorithm>
#include <unordered_map>

#include "core/error.hpp"

namespace porefines::geom {

namespace {

/// Lattice of s with one ring of pore around the box, so that every outline closes.
///
/// The ring stands half a pixel outside the outermost centres, on the box faces.
struct Lattice {
  const VoxelSolid& solid;
  int nx;
  int ny;

  explicit Lattice(const VoxelSolid& grains) : solid(grains), nx(grains.n[0]), ny(grains.n[1]) {}

  [[nodiscard]] Real value(int i, int j) const {
    if (i < 0 || j < 0 || i >= nx || j >= ny) {
      return 1e-3;  // outside: just pore, so that the crossing lies on the face
    }
    const auto s = static_cast<Real>(solid.s[static_cast<std::size_t>(i + Index{nx} * j)]);
    return s == 0 ? 1e-6 : s;
  }
  [[nodiscard]] Real x(int i) const { return std::clamp<Real>(i + 0.5, 0, nx) * solid.pixel; }
  [[nodiscard]] Real y(int j) const { return std::clamp<Real>(j + 0.5, 0, ny) * solid.pixel; }

  /// Number of the lattice edge from (i, j) along axis.
  [[nodiscard]] Index edge(int i, int j, int axis) const {
    return 2 * ((i + 1) + Index{nx + 2} * (j + 1)) + axis;
  }
  /// Where s = 0 on that edge.
  [[nodiscard]] Point2 crossing(Index number) const {
    const int axis = static_cast<int>(number % 2);
    const int i = static_cast<int>(number / 2 % (nx + 2)) - 1;
    const int j = static_cast<int>(number / 2 / (nx + 2)) - 1;
    const Real a = value(i, j);
    const Real b = axis == 0 ? value(i + 1, j) : value(i, j + 1);
    const Real t = std::clamp<Real>(a / (a - b), 0.001, 0.999);
    return axis == 0 ? Point2{x(i) + t * (x(i + 1) - x(i)), y(j)}
                     : Point2{x(i), y(j) + t * (y(j + 1) - y(j))};
  }
};

/// For each edge through which an outline enters a square, the edge through which it leaves.
using Links = std::unordered_map<Index, Index>;

/// Grain is on the left: walking round the square, the outline leaves where grain turns to pore
/// and enters where pore turns to grain; around a grain corner it leaves right after.
void link_square(const Lattice& lattice, int i, int j, Links& next) {
  // corners and edges counter-clockwise from the lower left
  const std::array<bool, 4> grain{lattice.value(i, j) < 0, lattice.value(i + 1, j) < 0,
                                  lattice.value(i + 1, j + 1) < 0, lattice.value(i, j + 1) < 0};
  const std::array<Index, 4> edge{lattice.edge(i, j, 0), lattice.edge(i + 1, j, 1),
                                  lattice.edge(i, j + 1, 0), lattice.edge(i, j, 1)};
  for (std::size_t a = 0; a < 4; ++a) {
    if (grain[a] || !grain[(a + 1) % 4]) {
      continue;
    }
    std::size_t b = (a + 1) % 4;
    while (grain[(b + 1) % 4]) {
      b = (b + 1) % 4;
    }
    next[edge[b]] = edge[a];
  }
}

/// Follow the links from an edge until they are used up.
Outline follow(const Lattice& lattice, Index at, Links& next) {
  Outline outline;
  for (auto step = next.find(at); step != next.end(); step = next.find(at)) {
    outline.push_back(lattice.crossing(at));
    at = step->second;
    next.erase(step);
  }
  return outline;
}

}  // namespace

std::vector<Outline> grain_outlines(const VoxelSolid& solid) {
  if (solid.n[2] != 1 || solid.window.size() != solid.n) {
    throw RunError("grain_outlines needs the solid of a whole 2D image");
  }
  const Lattice lattice(solid);
  Links next;
  for (int j = -1; j < lattice.ny; ++j) {
    for (int i = -1; i < lattice.nx; ++i) {
      link_square(lattice, i, j, next);
    }
  }
  std::vector<Index> starts;
  starts.reserve(next.size());
  for (const auto& [from, to] : next) {
    starts.push_back(from);
  }
  std::sort(starts.begin(), starts.end());
  std::vector<Outline> outlines;
  for (const Index start : starts) {
    Outline outline = follow(lattice, start, next);
    if (outline.size() >= 3) {
      outlines.push_back(std::move(outline));
    }
  }
  return outlines;
}

Real signed_area(const Outline& outline) {
  Real twice = 0;
  for (std::size_t a = 0; a < outline.size(); ++a) {
    const Point2& p = outline[a];
    const Point2& q = outline[(a + 1) % outline.size()];
    twice += p[0] * q[1] - p[1] * q[0];
  }
  return 0.5 * twice;
}

namespace {

Real distance_to_segment(const Point2& p, const Point2& a, const Point2& b) {
  const Real dx = b[0] - a[0];
  const Real dy = b[1] - a[1];
  const Real length2 = dx * dx + dy * dy;
  const Real along = (p[0] - a[0]) * dx + (p[1] - a[1]) * dy;
  const Real t = length2 > 0 ? std::clamp<Real>(along / length2, 0, 1) : 0;
  return std::hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy);
}

std::size_t furthest_from(const Outline& outline, std::size_t from) {
  std::size_t best = from;
  Real apart = -1;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Real d = std::hypot(outline[i][0] - outline[from][0], outline[i][1] - outline[from][1]);
    if (d > apart) {
      apart = d;
      best = i;
    }
  }
  return best;
}

Outline simplify_one(const Outline& outline, Real tolerance) {
  const std::size_t n = outline.size();
  const std::size_t first = furthest_from(outline, 0);
  const std::size_t second = furthest_from(outline, first);
  std::vector<bool> kept(n, false);
  kept[first] = kept[second] = true;
  std::vector<std::array<std::size_t, 2>> spans{{first, second}, {second, first}};
  std::size_t third = n;  // the point furthest from its chord, in case only two are kept
  Real furthest = -1;
  while (!spans.empty()) {
    const auto [a, b] = spans.back();
    spans.pop_back();
    std::size_t worst = n;
    Real off = 0;
    for (std::size_t i = (a + 1) % n; i != b; i = (i + 1) % n) {
      const Real d = distance_to_segment(outline[i], outline[a], outline[b]);
      if (worst == n || d > off) {
        worst = i;
        off = d;
      }
    }
    if (worst != n && off > furthest) {
      furthest = off;
      third = worst;
    }
    if (worst != n && off > tolerance) {
      kept[worst] = true;
      spans.push_back({a, worst});
      spans.push_back({worst, b});
    }
  }
  if (std::count(kept.begin(), kept.end(), true) < 3 && third < n) {
    kept[third] = true;
  }
  Outline out;
  for (std::size_t i = 0; i < n; ++i) {
    if (kept[i]) {
      out.push_back(outline[i]);
    }
  }
  return out;
}

}  // namespace

std::vector<Outline> simplify(const std::vector<Outline>& outlines, Real tolerance) {
  std::vector<Outline> out;
  out.reserve(outlines.size());
  for (const Outline& outline : outlines) {
    out.push_back(simplify_one(outline, tolerance));
  }
  return out;
}

}  // namespace porefines::geom
