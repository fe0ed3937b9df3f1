// SPDX-License-Identifier: MPL-2.0
#include "dem/surface_spline.hpp"

#include <algorithm>
#include <cstring>

namespace porefines::dem {

namespace {

/// Cubic B-spline weights of four neighbours and their first and second derivatives.
struct Weights {
  std::array<Real, 4> w;
  std::array<Real, 4> d;
  std::array<Real, 4> dd;
};

inline Weights weights(Real t) {
  constexpr Real sixth = 1.0 / 6;
  const Real u = 1 - t;
  return {{sixth * u * u * u, sixth * (4 - 6 * t * t + 3 * t * t * t),
           sixth * (4 - 6 * u * u + 3 * u * u * u), sixth * t * t * t},
          {-0.5 * u * u, 1.5 * t * t - 2 * t, 2 * u - 1.5 * u * u, 0.5 * t * t},
          {u, 3 * t - 2, 1 - 3 * t, t}};
}

/// First of the four neighbours along one axis, kept inside [first, past).
int locate(Real x, int first, int past, Real& t) {
  const Real inside = std::clamp<Real>(x, first + 1, past - 3 + 0.999999);
  const int low = static_cast<int>(std::floor(inside));
  t = inside - low;
  return low - 1 - first;
}

using Lanes [[gnu::vector_size(4 * sizeof(Real))]] = Real;  // of GCC and Clang: twice as fast here
using FloatLanes [[gnu::vector_size(4 * sizeof(float))]] = float;

Real sum(const std::array<Real, 4>& a, const Lanes& b) {
  return (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]);
}

/// Value and derivatives where nothing varies along z: a third of the work.
Jet flat_jet(const float* from, Index row, const Weights& a, const Weights& b) {
  Lanes f{};
  Lanes y{};
  Lanes yy{};
  for (std::size_t m = 0; m < 4; ++m, from += row) {
    FloatLanes single;
    std::memcpy(&single, from, sizeof single);
    const Lanes v = __builtin_convertvector(single, Lanes);
    f += b.w[m] * v;
    y += b.d[m] * v;
    yy += b.dd[m] * v;
  }
  return {
      sum(a.w, f), {sum(a.d, f), sum(a.w, y), 0}, sum(a.dd, f), sum(a.w, yy), 0, sum(a.d, y), 0, 0};
}

/// Sums over y and z of the four columns along x, with the weights of their derivatives.
struct Columns {
  Lanes f{}, y{}, z{}, yy{}, zz{}, yz{};

  void add(const float* c, Real wf, Real wy, Real wz, Real wyy, Real wzz, Real wyz) {
    FloatLanes single;
    std::memcpy(&single, c, sizeof single);
    const Lanes v = __builtin_convertvector(single, Lanes);
    f += wf * v;
    y += wy * v;
    z += wz * v;
    yy += wyy * v;
    zz += wzz * v;
    yz += wyz * v;
  }
};

}  // namespace

Jet SurfaceSpline::jet(const Vec3& x) const {
  const Int3 n = window.size();
  const Index row = n[0];
  Real tx = 0;
  Real ty = 0;
  Real tz = 0;
  const int i = locate(x.x, window.first[0], window.past[0], tx);
  const int j = locate(x.y, window.first[1], window.past[1], ty);
  const int k = flat ? 0 : locate(x.z, window.first[2], window.past[2], tz);
  const Weights a = weights(tx);
  const Weights b = weights(ty);
  const float* from = &c[static_cast<std::size_t>(geom::voxel_index(n, i, j, k))];
  if (flat) {
    return flat_jet(from, row, a, b);
  }
  Columns s;
  const Weights e = weights(tz);
  const Index skip = row * n[1] - 4 * row;
  for (std::size_t l = 0; l < 4; ++l, from += skip) {
    for (std::size_t m = 0; m < 4; ++m, from += row) {
      s.add(from, b.w[m] * e.w[l], b.d[m] * e.w[l], b.w[m] * e.d[l], b.dd[m] * e.w[l],
            b.w[m] * e.dd[l], b.d[m] * e.d[l]);
    }
  }
  return {sum(a.w, s.f),  {sum(a.d, s.f), sum(a.w, s.y), sum(a.w, s.z)},
          sum(a.dd, s.f), sum(a.w, s.yy),
          sum(a.w, s.zz), sum(a.d, s.y),
          sum(a.d, s.z),  sum(a.w, s.yz)};
}

SurfaceSpline make_spline(const geom::VoxelSolid& solid) {
  SurfaceSpline out{solid.window, solid.n[2] == 1, {}};
  const Int3 n = solid.window.size();
  for (std::size_t axis = 0; axis < (out.flat ? 2U : 3U); ++axis) {
    ++out.window.first[axis];
    --out.window.past[axis];
  }
  const Int3 m = out.window.size();
  if (m[0] < 4 || m[1] < 4 || (!out.flat && m[2] < 4)) {
    out.window.past = out.window.first;
    return out;
  }
  out.c.resize(static_cast<std::size_t>(product(m)));
  const Index y = n[0];
  const Index z = out.flat ? 0 : y * n[1];
  auto* c = out.c.data();
  for (int k = 0; k < m[2]; ++k) {
    for (int j = 0; j < m[1]; ++j, c += m[0]) {
      const float* s =
          &solid.s[static_cast<std::size_t>(geom::voxel_index(n, 1, j + 1, out.flat ? 0 : k + 1))];
      for (int i = 0; i < m[0]; ++i) {
        const float along = (s[i - 1] + s[i + 1]) + (s[i - y] + s[i + y]) + (s[i - z] + s[i + z]);
        c[i] = s[i] - (along - 6 * s[i]) / 6;
      }
    }
  }
  return out;
}

}  // namespace porefines::dem
