// SPDX-License-Identifier: MPL-2.0
#include "geom/throat_shape.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace porefines::geom {

namespace {

constexpr Real farthest_ray = 8;  ///< widths

/// Half of the directions, evenly spread: 48 in the plane, 160 on the sphere (Fibonacci lattice).
std::vector<Vec3> half_directions(bool flat) {
  std::vector<Vec3> out;
  if (flat) {
    for (int a = 0; a < 48; ++a) {
      const Real angle = std::numbers::pi * a / 48;
      out.push_back({std::cos(angle), std::sin(angle), 0});
    }
    return out;
  }
  constexpr int count = 160;
  for (int a = 0; a < count; ++a) {
    const Real z = (a + 0.5) / count;
    const Real angle = 2 * std::numbers::pi * a / std::numbers::phi;
    const Real r = std::sqrt(1 - z * z);
    out.push_back({r * std::cos(angle), r * std::sin(angle), z});
  }
  return out;
}

/// A unit vector normal to e.
Vec3 any_normal(const Vec3& e) {
  const Vec3 off = std::abs(e.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 n = cross(e, off);
  return n / norm(n);
}

}  // namespace

ThroatShape::ThroatShape(const VoxelSolid& solid, const Basins& pores,
                         const std::array<bool, 3>& periodic, const ThroatFrame& frame)
    : solid_(solid),
      pores_(pores),
      periodic_(periodic),
      frame_(frame),
      flat_(solid.n[2] == 1),
      directions_(half_directions(flat_)) {
  frame_.depth = frame_.depth > 0 ? frame_.depth : solid.pixel;
  if (!frame_.distance) {
    frame_.distance = [&solid](const Vec3& x) { return signed_distance(solid, x); };
  }
}

Real ThroatShape::way_to_face(const Vec3& x, const Vec3& e) const {
  Real way = std::numeric_limits<Real>::max();
  for (int a = 0; a < 3; ++a) {
    if (frame_.walls[static_cast<std::size_t>(a)] && !(flat_ && a == 2) && e[a] != 0) {
      const Real face = e[a] > 0 ? solid_.n[a] * solid_.pixel : 0;
      way = std::min(way, std::max((face - x[a]) / e[a], 0.0));
    }
  }
  return way;
}

/// Distance from x along e to the surface or a wall [m], at most `most`; marching by the distance
/// itself.
Real ThroatShape::way_to_wall(const Vec3& x, const Vec3& e, Real most) const {
  const Real close = 0.01 * solid_.pixel;
  const Real end = std::min(most, way_to_face(x, e));
  Real t = 0;
  while (t < end) {
    const Real s = frame_.distance(x + t * e);
    if (s < close) {
      return std::min(t + s, end);
    }
    t += std::max(0.9 * s, 2 * close);
  }
  return end;
}

std::optional<Throat> ThroatShape::measure(const Vec3& x, std::int32_t low,
                                           std::int32_t high) const {
  auto throat = shortest_chord(away_from_walls(x));
  if (!throat) {
    return {};
  }
  find_normal(*throat);
  if (const auto narrowest = shortest_chord(middle_of_narrowest(*throat))) {
    if (narrowest->width < throat->width + 0.7 * solid_.pixel) {
      throat = narrowest;
      find_normal(*throat);
    }
  }
  follow_middle(*throat);
  orient(*throat, low, high);
  throat->behind = extent(*throat, -1);
  throat->ahead = extent(*throat, 1);
  throat->centre = inside(throat->centre);
  if (flat_) {
    throat->centre.z = throat->from.z = throat->to.z = 0.5 * frame_.depth;
  }
  return throat;
}

/// The distance mirrors at walls and so is largest on them: to where the grain is as near as the
/// wall, lest a leaning chord cuts a corner.
Vec3 ThroatShape::away_from_walls(Vec3 x) const {
  constexpr int most_steps = 1000;
  for (int n = 0; n < most_steps; ++n) {
    Vec3 off;
    Real nearest = std::numeric_limits<Real>::max();
    for (int a = 0; a < 3; ++a) {
      for (const Real sign : {-1.0, 1.0}) {
        Vec3 e;
        e[a] = sign;
        if (const Real way = way_to_face(x, e); way < nearest) {
          nearest = way;
          off = -1 * e;
        }
      }
    }
    if (nearest >= frame_.distance(x) - 0.01 * solid_.pixel) {
      break;
    }
    x += std::min(0.5 * solid_.pixel, frame_.distance(x) - nearest) * off;
  }
  return x;
}

std::optional<Throat> ThroatShape::shortest_chord(const Vec3& x) const {
  constexpr Real finest = 0.5;  // [pixels] what a voxel image can tell at all
  std::optional<Throat> throat;
  Real shortest = 8 * std::max(frame_.distance(x), solid_.pixel);
  const auto take_if_shorter = [&](const Vec3& e) {
    const Real ahead = way_to_wall(x, e, shortest);
    if (ahead >= shortest) {
      return;
    }
    const Real behind = way_to_wall(x, -1 * e, shortest - ahead);
    if (ahead + behind < shortest) {
      shortest = ahead + behind;
      throat = Throat{.centre = x + 0.5 * (ahead - behind) * e,
                      .across = e,
                      .width = std::max(shortest, finest * solid_.pixel),
                      .from = x - behind * e,
                      .to = x + ahead * e};
    }
  };
  std::for_each(directions_.begin(), directions_.end(), take_if_shorter);
  for (Real turn = flat_ ? 0.03 : 0.1; throat && turn > 0.01; turn *= 0.5) {
    const Vec3 e = throat->across;
    const Vec3 u = flat_ ? Vec3{-e.y, e.x, 0} : any_normal(e);
    const Vec3 v = flat_ ? Vec3{} : cross(e, u);
    for (const Vec3& side : {u, -1 * u, v, -1 * v}) {
      const Vec3 turned = e + turn * side;
      take_if_shorter(turned / norm(turned));
    }
  }
  return throat;
}

Real ThroatShape::section(const Throat& throat, const Vec3& normal, int rays) const {
  const Vec3 up = cross(normal, throat.across);
  const Real step = 2 * std::numbers::pi / rays;
  Real sum = 0;
  for (int a = 0; a < rays; ++a) {
    const Real angle = (a + 0.5) * step;
    const Vec3 e = std::cos(angle) * throat.across + std::sin(angle) * up;
    const Real r = way_to_wall(throat.centre, e, farthest_ray * throat.width);
    sum += 0.5 * r * r * step;
  }
  return sum;
}

void ThroatShape::find_normal(Throat& throat) const {
  if (flat_) {
    throat.normal = {throat.across.y, -throat.across.x, 0};
    throat.area = throat.width * frame_.depth;
    return;
  }
  constexpr int planes = 16;
  const Vec3 u = any_normal(throat.across);
  const Vec3 v = cross(throat.across, u);
  Real smallest = std::numeric_limits<Real>::max();
  for (int a = 0; a < planes; ++a) {
    const Real angle = std::numbers::pi * a / planes;
    const Vec3 normal = std::cos(angle) * u + std::sin(angle) * v;
    const Real area = section(throat, normal, 16);
    if (area < smallest) {
      smallest = area;
      throat.normal = normal;
    }
  }
  throat.area = section(throat, throat.normal, 64);
}

/// The normal along the flow axis, or where it has no share of that, along the next that it has.
void ThroatShape::orient(Throat& throat, std::int32_t low, std::int32_t high) const {
  constexpr Real none = 1e-9;
  for (int a = 0; a < 3; ++a) {
    const Real n = throat.normal[(frame_.flow_axis + a) % 3];
    if (std::abs(n) > none) {
      throat.normal *= n > 0 ? 1 : -1;
      break;
    }
  }
  throat.pore_behind = low;
  throat.pore_ahead = high;
  const Real step = 0.5 * solid_.pixel;
  const int steps = static_cast<int>(3 * throat.width / step) + 2;
  for (int n = 1; n <= steps; ++n) {
    const Real t = n * step;
    const std::int32_t ahead = basin_at(throat.centre + t * throat.normal);
    const std::int32_t behind = basin_at(throat.centre - t * throat.normal);
    if ((ahead == low && behind != low) || (behind == high && ahead != high)) {
      std::swap(throat.pore_behind, throat.pore_ahead);
      return;
    }
    if (ahead == high && behind == low) {
      return;
    }
  }
}

std::int32_t ThroatShape::basin_at(const Vec3& x) const {
  const Vec3 y = inside(x);
  Index v = 0;
  for (int a = 2; a >= 0; --a) {
    const int i = flat_ && a == 2 ? 0 : static_cast<int>(std::floor(y[a] / solid_.pixel));
    v = v * solid_.n[a] + std::clamp(i, 0, solid_.n[a] - 1);
  }
  return pores_.label[static_cast<std::size_t>(v)];
}

/// Through periodic faces to the other side; mirrors hold what lies beyond them on the face.
Vec3 ThroatShape::inside(Vec3 x) const {
  for (int a = 0; a < (flat_ ? 2 : 3); ++a) {
    const Real size = solid_.n[a] * solid_.pixel;
    x[a] = periodic_[static_cast<std::size_t>(a)] ? x[a] - size * std::floor(x[a] / size)
                                                  : std::clamp<Real>(x[a], 0, size);
  }
  return x;
}

}  // namespace porefines::geom
