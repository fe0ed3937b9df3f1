// SPDX-License-Identifier: MPL-2.0
#include "dem/surface_field.hpp"

#include <algorithm>

#include "dem/surface_foot.hpp"
#include "geom/nearest.hpp"

namespace porefines::dem {

namespace {

constexpr int block_edge = 2;    // [voxels] of the clearance grid
constexpr Real spacing = 0.75;   // [voxels] how much farther than the surface its next point may be
constexpr Real border = 3;       // [voxels] that the spline and Newton's steps need around a foot
constexpr Real near_foot = 0.9;  // [voxels] tangential offset of a point that may start a descent

int floor_div(int a, int b) {
  return a >= 0 ? a / b : -((b - 1 - a) / b);
}

/// Place of a point in the clearance grid, -1 outside.
Index block_of(const DistanceField& field, const Vec3& x) {
  Int3 at{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    at[a] =
        static_cast<int>(std::floor((x[axis] + 0.5) * (1.0 / block_edge))) - field.first_block[a];
    if (at[a] < 0 || at[a] >= field.blocks[a]) {
      return -1;
    }
  }
  return geom::voxel_index(field.blocks, at[0], at[1], at[2]);
}

/// Marks voxels that hold surface points, in the window grown by `by`.
std::vector<std::uint8_t> mark_points(const DistanceField& field, const geom::Window& grown) {
  const Int3 n = grown.size();
  std::vector<std::uint8_t> mark(static_cast<std::size_t>(product(n)), 0);
  const SurfacePoints& points = field.points;
  for (std::size_t p = 0; p < points.x.size(); ++p) {
    const int i = static_cast<int>(std::floor(points.x[p] + 0.5F)) - grown.first[0];
    const int j = static_cast<int>(std::floor(points.y[p] + 0.5F)) - grown.first[1];
    const int k = static_cast<int>(std::floor(points.z[p] + 0.5F)) - grown.first[2];
    mark[static_cast<std::size_t>(geom::voxel_index(n, i, j, k))] = 1;
  }
  return mark;
}

void fill_clearance(DistanceField& field, int reach) {
  const SurfaceSpline& spline = field.spline;
  geom::Window grown = spline.window;
  for (std::size_t a = 0; a < 3; ++a) {
    field.first_block[a] = floor_div(spline.window.first[a], block_edge);
    field.blocks[a] = floor_div(spline.window.past[a] - 1, block_edge) - field.first_block[a] + 1;
    if (a < 2 || !spline.flat) {
      grown.first[a] -= reach;
      grown.past[a] += reach;
    }
  }
  field.clearance.assign(static_cast<std::size_t>(product(field.blocks)),
                         static_cast<float>(reach));
  const Real corners = spline.flat ? std::sqrt(2.0) : std::sqrt(3.0);
  const Int3 n = spline.window.size();
  geom::for_each_nearest(
      mark_points(field, grown), grown.size(), reach,
      [&](int j, int k, const std::vector<geom::Offset>& row) {
        const int y = spline.window.first[1] + j;
        const int z = spline.window.first[2] + k;
        for (int i = 0; i < n[0]; ++i) {
          const int x = spline.window.first[0] + i;
          const geom::Offset& d = row[static_cast<std::size_t>(i)];
          float& least = field.clearance[static_cast<std::size_t>(
              block_of(field, {static_cast<Real>(x), static_cast<Real>(y), static_cast<Real>(z)}))];
          if (d.dx != geom::Offset::nothing) {
            const Real away = std::hypot(d.dx, d.dy, d.dz) - corners;
            least = std::min(least, static_cast<float>(std::max<Real>(away, 0)));
          }
          if (spline.coefficient(x, y, z) < 0) {
            least = -1;
          }
        }
      });
}

/// Points of the surface from which descents start, nearest first.
struct Starts {
  struct Start {
    Real square;
    std::size_t point;
  };
  static constexpr std::size_t capacity = 256;
  std::array<Start, capacity> start;
  std::size_t count = 0;
  int lost = 0;
};

/// Points near a foot: where the way to the centre is almost along the normal.
void find_starts(const SurfacePoints& points, const Vec3& c, Real distance, Starts& out) {
  points.for_each_near(c, distance, [&](std::size_t p) {
    const Vec3 away = c - Vec3{points.x[p], points.y[p], points.z[p]};
    const SurfacePoints::Shape& shape = points.shape[p];
    const Real d = away.x * shape.normal[0] + away.y * shape.normal[1] + away.z * shape.normal[2];
    const Real square = dot(away, away);
    const Real most = near_foot * (1 + std::abs(d) * shape.bend);
    if (square - d * d < most * most) {
      if (out.count < Starts::capacity) {
        out.start[out.count++] = {square, p};
      } else {
        ++out.lost;
      }
    }
  });
  std::sort(out.start.begin(), out.start.begin() + static_cast<std::ptrdiff_t>(out.count),
            [](const auto& a, const auto& b) {
              return a.square < b.square || (a.square == b.square && a.point < b.point);
            });
}

struct Feet {
  std::array<Foot, 2 * TouchList::capacity> foot;
  std::size_t count = 0;
  int lost = 0;
};

/// All minima nearer than `within`, each once.
void descend(const DistanceField& field, const Vec3& c, Real within, const Starts& starts,
             Feet& out) {
  std::array<Vec3, Starts::capacity> seen;
  std::size_t seen_count = 0;
  const auto is_seen = [&](const Vec3& x, Real distance) {
    return std::any_of(seen.begin(), seen.begin() + static_cast<std::ptrdiff_t>(seen_count),
                       [&](const Vec3& y) { return dot(x - y, x - y) < distance * distance; });
  };
  for (std::size_t s = 0; s < starts.count && seen_count + 2 < seen.size(); ++s) {
    const std::size_t p = starts.start[s].point;
    const Vec3 from{field.points.x[p], field.points.y[p], field.points.z[p]};
    if (is_seen(from, near_foot)) {
      continue;
    }
    const Foot foot = find_foot(field.spline, c, from);
    seen[seen_count++] = from;
    if (!foot.found) {
      continue;
    }
    const bool known =
        std::any_of(out.foot.begin(), out.foot.begin() + static_cast<std::ptrdiff_t>(out.count),
                    [&](const Foot& other) { return norm(foot.at - other.at) < 0.02; });
    if (known) {
      continue;
    }
    seen[seen_count++] = foot.at;
    if (foot.distance < within) {
      if (out.count < out.foot.size()) {
        out.foot[out.count++] = foot;
      } else {
        ++out.lost;
      }
    }
  }
}

/// Nearest first. The nearest foot knows whether the centre is in the pore; then feet on the far
/// side of a thin grain do not count. A centre in a grain leaves it by the nearest way.
void keep_near_side(Feet& feet) {
  const auto first = feet.foot.begin();
  auto past = first + static_cast<std::ptrdiff_t>(feet.count);
  std::sort(first, past, [](const Foot& a, const Foot& b) {
    return std::abs(a.distance) < std::abs(b.distance);
  });
  if (feet.count > 0 && first->distance <= 0) {
    past = first + 1;
  } else {
    past = std::remove_if(first, past, [](const Foot& foot) { return foot.distance <= 0; });
  }
  feet.count = static_cast<std::size_t>(past - first);
}

bool covers(const DistanceField& field, const Vec3& x, Real distance) {
  const geom::Window& window = field.spline.window;
  for (int axis = 0; axis < (field.spline.flat ? 2 : 3); ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    if (x[axis] - distance < window.first[a] || x[axis] + distance > window.past[a] - 1) {
      return false;
    }
  }
  return !field.spline.c.empty();
}

/// A centre deep in a grain, no surface in reach: out along the gradient.
void push_out(const DistanceField& field, const Vec3& x, Real radius, TouchList& out) {
  const Jet jet = field.spline.jet(x);
  out.inside = true;
  if (norm(jet.g) > 0) {
    out.add({jet.g / norm(jet.g), (jet.f - radius) * field.pixel, {}, 0, 1, 0});
  } else {
    ++out.lost;
  }
}

}  // namespace

DistanceField make_field(const geom::VoxelSolid& solid, Real largest, const Vec3& corner) {
  DistanceField out;
  out.corner = corner;
  out.pixel = solid.pixel;
  out.spline = make_spline(solid);
  out.points = find_points(out.spline);
  if (!out.spline.c.empty()) {
    const Real reach = std::ceil(largest / solid.pixel + spacing) + 3;
    fill_clearance(out, static_cast<int>(std::clamp<Real>(reach, 4, 500)));
  }
  return out;
}

void find_touches(const DistanceField& field, const Vec3& centre, Real radius, Real reach,
                  TouchList& out) {
  const Real scale = 1 / field.pixel;
  Vec3 x = scale * (centre - field.corner) - Vec3{0.5, 0.5, 0.5};
  x.z = field.spline.flat ? 0 : x.z;
  const Real r = scale * radius;
  const Real within = r + scale * reach;
  const Index block = block_of(field, x);
  if (block >= 0 && field.clearance[static_cast<std::size_t>(block)] > within + spacing &&
      covers(field, x, within)) {
    return;
  }
  if (!covers(field, x, within + border)) {
    out.uncovered = true;
    if (block < 0) {
      return;
    }
  }
  Starts starts;
  find_starts(field.points, x, within + spacing, starts);
  Feet feet;
  descend(field, x, within, starts, feet);
  out.lost += starts.lost + feet.lost;
  keep_near_side(feet);
  const std::span<Foot> found(feet.foot.data(), feet.count);
  if (found.size() > 1) {
    share_force(field.spline, x, r, found);
  }
  for (const Foot& foot : found) {
    out.inside = out.inside || foot.distance <= 0;
    out.add({foot.normal, (foot.distance - r) * field.pixel, {}, 0, foot.share, 0});
  }
  if (found.empty() && field.clearance[static_cast<std::size_t>(block)] < 0 &&
      field.spline.jet(x).f < 0) {
    push_out(field, x, r, out);
  }
}

}  // namespace porefines::dem
