// SPDX-License-Identifier: MPL-2.0
#include "dem/surface_points.hpp"

#include <algorithm>

namespace porefines::dem {

namespace {

constexpr float near_surface = 1.3F;  // [voxels] |s| of voxels from which a point is looked for
constexpr Real own_share = 0.65;      // [voxels] from the voxel centre, per axis
constexpr Real least_slope = 0.2;
constexpr Real settled =
    0.02;  // [voxels] of the last step: a grain that smoothing took away has no point

Vec3 apply(const Jet& j, const Vec3& a) {
  return {j.xx * a.x + j.xy * a.y + j.xz * a.z, j.xy * a.x + j.yy * a.y + j.yz * a.z,
          j.xz * a.x + j.yz * a.y + j.zz * a.z};
}

struct Found {
  Vec3 x;
  SurfacePoints::Shape shape;
  Int3 bin;
};

/// The point of the surface that belongs to a voxel, if any.
bool find_point(const SurfaceSpline& spline, const Int3& voxel, Found& out) {
  const Vec3 centre{1.0 * voxel[0], 1.0 * voxel[1], 1.0 * voxel[2]};
  Vec3 x = centre;
  Jet jet;
  Real last = 0;
  for (int step = 0; step < 4; ++step) {
    jet = spline.jet(x);
    const Real square = dot(jet.g, jet.g);
    if (square < least_slope * least_slope) {
      return false;
    }
    x -= (jet.f / square) * jet.g;
    last = std::abs(jet.f) / std::sqrt(square);
    const Vec3 off = x - centre;
    if (std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)}) > 1.5) {
      return false;
    }
  }
  const Vec3 off = x - centre;
  if (last > settled || std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)}) > own_share) {
    return false;
  }
  const Bending b = bending(jet);
  const Real mean = 0.5 * (b.uu + b.vv);
  const Real most = mean + std::hypot(0.5 * (b.uu - b.vv), b.uv);
  out.x = x;
  out.shape = {{static_cast<float>(b.n.x), static_cast<float>(b.n.y), static_cast<float>(b.n.z)},
               static_cast<float>(std::clamp<Real>(most, 0, 4))};
  for (int axis = 0; axis < 3; ++axis) {
    out.bin[static_cast<std::size_t>(axis)] = SurfacePoints::bin_of(x[axis]);
  }
  return true;
}

std::vector<Found> collect(const SurfaceSpline& spline) {
  std::vector<Found> found;
  geom::Window inner = spline.window;
  for (std::size_t a = 0; a < (spline.flat ? 2U : 3U); ++a) {
    inner.first[a] += 2;
    inner.past[a] -= 2;
  }
  Found one{};
  for (int k = inner.first[2]; k < inner.past[2]; ++k) {
    for (int j = inner.first[1]; j < inner.past[1]; ++j) {
      for (int i = inner.first[0]; i < inner.past[0]; ++i) {
        if (std::abs(spline.coefficient(i, j, k)) < near_surface &&
            find_point(spline, {i, j, k}, one)) {
          found.push_back(one);
        }
      }
    }
  }
  return found;
}

}  // namespace

Bending bending(const Jet& jet) {
  Bending out;
  out.slope = norm(jet.g);
  if (out.slope == 0) {
    return out;
  }
  out.n = jet.g / out.slope;
  const Vec3 least = std::abs(out.n.z) < 0.8 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const Vec3 u = cross(out.n, least);
  out.u = u / norm(u);
  out.v = cross(out.n, out.u);
  const Vec3 hu = apply(jet, out.u);
  out.uu = dot(out.u, hu) / out.slope;
  out.uv = dot(out.v, hu) / out.slope;
  out.vv = dot(out.v, apply(jet, out.v)) / out.slope;
  return out;
}

SurfacePoints find_points(const SurfaceSpline& spline) {
  SurfacePoints out;
  if (spline.c.empty()) {
    out.start.assign(1, 0);
    return out;
  }
  for (std::size_t a = 0; a < 3; ++a) {
    out.first_bin[a] = SurfacePoints::bin_of(spline.window.first[a] - 1);
    out.bins[a] = SurfacePoints::bin_of(spline.window.past[a]) - out.first_bin[a] + 1;
  }
  const auto found = collect(spline);
  const auto bin = [&](const Found& f) {
    return static_cast<std::size_t>(geom::voxel_index(out.bins, f.bin[0] - out.first_bin[0],
                                                      f.bin[1] - out.first_bin[1],
                                                      f.bin[2] - out.first_bin[2]));
  };
  out.start.assign(static_cast<std::size_t>(product(out.bins)) + 1, 0);
  for (const Found& f : found) {
    ++out.start[bin(f) + 1];
  }
  for (std::size_t b = 1; b < out.start.size(); ++b) {
    out.start[b] += out.start[b - 1];
  }
  out.x.resize(found.size());
  out.y.resize(found.size());
  out.z.resize(found.size());
  out.shape.resize(found.size());
  auto next = out.start;
  for (const Found& f : found) {
    const auto p = static_cast<std::size_t>(next[bin(f)]++);
    out.x[p] = static_cast<float>(f.x.x);
    out.y[p] = static_cast<float>(f.x.y);
    out.z[p] = static_cast<float>(f.x.z);
    out.shape[p] = f.shape;
  }
  return out;
}

}  // namespace porefines::dem
