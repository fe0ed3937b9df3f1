// SPDX-License-Identifier: MPL-2.0
#include "dem/surface_field.hpp"

#include <algorithm>
#include <limits>

#include "dem/surface_foot.hpp"
#include "geom/nearest.hpp"
#include "geom/surface_seeds.hpp"

namespace porefines::dem {

namespace {

constexpr Real spacing = 0.75;   // [voxels] how much farther than the surface its next point may be
constexpr Real border = 3;       // [voxels] that the spline and Newton's steps need around a foot
constexpr Real near_foot = 1.0;  // [voxels] tangential offset of a point that may start a descent
constexpr Real same_foot = 0.6;  // [voxels] starts that lead this close to a foot are not followed

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
  const geom::Window& window = spline.window;
  const int axes = spline.flat ? 2 : 3;
  const Real corners = std::sqrt(axes) + spacing;  // point and query anywhere in their voxels
  const Int3 n = window.size();
  field.clearance.resize(static_cast<std::size_t>(product(n)));
  const auto to_border = [&](int i, std::size_t a) { return std::min(i, n[a] - 1 - i); };
  const geom::Window grown = geom::grown(window, reach, spline.flat);
  geom::for_each_nearest(
      mark_points(field, grown), grown.size(), reach,
      [&](int j, int k, const std::vector<geom::Offset>& row) {
        const int across = axes == 2 ? to_border(j, 1) : std::min(to_border(j, 1), to_border(k, 2));
        for (int i = 0; i < n[0]; ++i) {
          const geom::Offset& d = row[static_cast<std::size_t>(i)];
          const auto v = static_cast<std::size_t>(geom::voxel_index(n, i, j, k));
          const Real known = std::min(across, to_border(i, 0)) - border - 0.5;
          const Real away = d.dx == geom::Offset::nothing
                                ? reach - corners
                                : std::sqrt(Real{1} * d.dx * d.dx + Real{1} * d.dy * d.dy +
                                            Real{1} * d.dz * d.dz) -
                                      corners;
          const Real least = std::clamp<Real>(std::min(away, known), 0, 63);
          field.clearance[v] = spline.c[v] < 0 ? 0 : static_cast<std::uint8_t>(4 * least);
        }
      });
}

/// A point of the surface from which a descent may start.
struct Start {
  Real square;  ///< of its distance from the centre
  Vec3 at;
  Vec3 leads_to;  ///< where Newton's first step goes, roughly
};

struct Starts {
  static constexpr std::size_t capacity = 256;
  std::size_t count = 0;
  int lost = 0;
  Start nearest{};  ///< of all points, likely to lead to a foot or not
  std::array<Start, capacity> start;
};

/// Points near a foot: where the way to the centre is almost along the normal.
void find_starts(const SurfacePoints& points, const Vec3& c, Real within, Starts& out) {
  out.count = 0, out.lost = 0;
  out.nearest = {std::numeric_limits<Real>::max(), {}, {}};
  constexpr Real slack =
      0.15;  // a foot is at most so much nearer than the tangent plane at a start
  points.for_each_near(c, within + spacing, [&](std::size_t p) {
    const SurfacePoints::Shape& shape = points.shape[p];
    const Vec3 at{points.x[p], points.y[p], points.z[p]};
    const Vec3 normal{shape.normal[0], shape.normal[1], shape.normal[2]};
    const Vec3 away = c - at;
    const Real d = dot(away, normal);
    const Real square = dot(away, away);
    const Real stretch = 1 + std::abs(d) * shape.bend;
    if (square < out.nearest.square) {
      out.nearest = {square, at, at};
    }
    if (d > within + slack || square - d * d > near_foot * near_foot * stretch * stretch) {
      return;
    }
    if (out.count < Starts::capacity) {
      out.start[out.count++] = {square, at, at + (1 / stretch) * (away - d * normal)};
    } else {
      ++out.lost;
    }
  });
  std::sort(out.start.begin(), out.start.begin() + static_cast<std::ptrdiff_t>(out.count),
            [](const Start& a, const Start& b) { return a.square < b.square; });
}

struct Feet {
  std::array<Foot, 2 * TouchList::capacity> foot;
  std::size_t count = 0;
  int lost = 0;
};

bool is_near(const Vec3& a, const Vec3& b, Real distance) {
  return dot(a - b, a - b) < distance * distance;
}

/// The minima that the starts lead to, each once.
void descend(const DistanceField& field, const Vec3& c, const Starts& starts, Feet& out) {
  const auto leads_to_known = [&](const Start& start) {
    return std::any_of(out.foot.begin(), out.foot.begin() + static_cast<std::ptrdiff_t>(out.count),
                       [&](const Foot& foot) {
                         return is_near(foot.at, start.leads_to, same_foot) ||
                                is_near(foot.at, start.at, near_foot);
                       });
  };
  for (std::size_t s = 0; s < starts.count; ++s) {
    if (leads_to_known(starts.start[s])) {
      continue;
    }
    const Foot foot = find_foot(field.spline, c, starts.start[s].at, {out.foot.data(), out.count});
    if (!foot.found) {
      continue;
    }
    if (out.count < out.foot.size()) {
      out.foot[out.count++] = foot;
    } else {
      ++out.lost;
    }
  }
}

/// On edges sharper than a voxel no point may look like the start of a descent: no foot is farther than the nearest
/// point of the surface.
void descend_from_nearest(const DistanceField& field, const Vec3& c, Real within,
                          const Start& nearest, Feet& out) {
  if (nearest.square >= within * within || out.count == out.foot.size()) {
    return;
  }
  for (std::size_t f = 0; f < out.count; ++f) {
    const Real distance = out.foot[f].distance;
    if (distance * distance <= nearest.square) {
      return;
    }
  }
  Foot foot = find_foot(field.spline, c, nearest.at);
  if (!foot.found) {  // the descent did not settle: near the foot at least
    const Real distance = std::max(std::sqrt(nearest.square), 1e-6);
    const Real side = field.spline.jet(c).f < 0 ? -1 : 1;
    foot = {nearest.at, (side / distance) * (c - nearest.at), side * distance, 1, true};
  }
  out.foot[out.count++] = foot;
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
  const Vec3 x = to_voxels(field, centre, scale);
  const Real r = scale * radius;
  const Real within = r + scale * reach;
  if (!may_touch(field, x, within)) {
    return;
  }
  if (!covers(field, x, within + border)) {
    out.uncovered = true;
    return;
  }
  static thread_local Starts starts;  // kilobytes that would be cleared at every call
  static thread_local Feet feet;
  feet.count = 0, feet.lost = 0;
  find_starts(field.points, x, within, starts);
  descend(field, x, starts, feet);
  descend_from_nearest(field, x, within, starts.nearest, feet);
  out.lost += starts.lost + feet.lost;
  const std::span<Foot> found = keep_near_side({feet.foot.data(), feet.count}, within);
  if (found.size() > 1) {
    share_force(field.spline, x, r, found);
  }
  for (const Foot& foot : found) {
    out.inside = out.inside || foot.distance <= 0;
    out.add({foot.normal, (foot.distance - r) * field.pixel, {}, 0, foot.share, 0});
  }
  if (!found.empty()) {
    return;
  }
  if (field.spline.jet(x).f < 0) {
    push_out(field, x, r, out);
  } else if (starts.count > 0 && starts.start[0].square < (r - 0.5) * std::abs(r - 0.5)) {
    ++out.lost;  // the surface is within the sphere, but no descent found its foot
  }
}

}  // namespace porefines::dem
