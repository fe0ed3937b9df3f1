// SPDX-License-Identifier: MPL-2.0
#include "geom/voxel_solid.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "core/error.hpp"
#include "geom/nearest.hpp"
#include "geom/surface_seeds.hpp"

namespace porefines::geom {

namespace {

constexpr Index piece_voxels = Index{1} << 26;  // larger windows are built in slabs to save memory

/// Nearest integer; std::lround is a library call.
int nearest_integer(float x) {
  return static_cast<int>(std::floor(x + 0.5F));
}

/// Distance from x to a seed's piece of the surface: to its plane as long as the foot is near the seed,
///
///     sign(s) sqrt(s^2 + max(0, t - 3/4)^2),   t^2 = |x - (q - s_q n_q)|^2 - s^2,
///
/// and around its rim where the plane would reach beyond the surface (outside a corner).
float to_piece(float s, float apart) {
  constexpr float rim = 0.75F;
  const float beyond = std::sqrt(std::max(0.0F, apart - s * s)) - rim;
  return beyond > 0 ? std::copysign(std::sqrt(s * s + beyond * beyond), s) : s;
}

/// Signed distance at a voxel by the tangent plane at its foot point.
///
/// Start from the nearest seed q (offset d = x - q):  s = s_q + n_q . d; the foot is x - s n_q;
/// if there is a seed at the voxel of the foot and its plane is closer to x, take it and repeat.
/// @param v  place of the voxel in the window of the surface
float carry(const SurfaceSeeds& surface, const std::array<Index, 3>& stride, Index v,
            const Offset& offset, float most) {
  constexpr int steps = 3;
  float s = 0;
  float nearest = std::numeric_limits<float>::max();
  std::array<int, 3> d{-offset.dx, -offset.dy, -offset.dz};
  for (int step = 0; step < steps; ++step) {
    const Index q = v - d[0] - stride[1] * d[1] - stride[2] * d[2];
    const std::int32_t index = surface.index[static_cast<std::size_t>(q)];
    if (index < 0) {
      break;
    }
    const auto& [own, n] = surface.seed[static_cast<std::size_t>(index)];
    const auto x = static_cast<float>(d[0]);
    const auto y = static_cast<float>(d[1]);
    const auto z = static_cast<float>(d[2]);
    const float square = x * x + y * y + z * z;
    if (n[0] == 0 && n[1] == 0 && n[2] == 0) {  // a ball of diameter one
      const float ball = std::sqrt(square) - 0.5F;
      return ball * ball < nearest ? (own > 0 ? -ball : ball) : to_piece(s, nearest);
    }
    const float along = n[0] * x + n[1] * y + n[2] * z;
    // |x - foot of q|^2 with the foot at q - s_q n_q
    const float apart = square + own * (2 * along + own);
    if (apart >= nearest) {
      break;
    }
    nearest = apart;
    s = own + along;
    if (std::abs(s) > most) {  // saturates anyhow, and the foot may leave the window
      break;
    }
    const std::array<int, 3> foot{nearest_integer(s * n[0]), nearest_integer(s * n[1]),
                                  nearest_integer(s * n[2])};
    if (foot == d) {
      break;
    }
    d = foot;
  }
  return to_piece(s, nearest);
}

/// Distance at one voxel from its nearest seed (offset) and, close by, from its own.
float distance_at(const SurfaceSeeds& surface, const std::array<Index, 3>& stride, Index v,
                  const Offset& offset, float band) {
  const auto side = static_cast<float>(surface.side[static_cast<std::size_t>(v)]);
  if (offset.dx == Offset::nothing) {
    return side * band;
  }
  const float s = carry(surface, stride, v, offset, band + 1);
  const std::int32_t index = surface.index[static_cast<std::size_t>(v)];
  if (index >= 0) {
    const float own = surface.seed[static_cast<std::size_t>(index)].s;
    const float weight = std::clamp(2 * std::abs(own) - 1, 0.0F, 1.0F);
    return own + weight * (s - own);
  }
  constexpr float least = 0.05F;  // the side is known even where planes disagree with it
  return side * std::clamp(side * s, least, band);
}

void fill(const VoxelView& image, const Surroundings& beyond, const Window& window,
          const Smoothing& smoothing, VoxelSolid& out) {
  const bool flat = image.n[2] == 1;
  const int reach = static_cast<int>(std::ceil(smoothing.band)) + 2;
  const Window inside{{0, 0, 0}, image.n};
  Window counted = window;
  for (std::size_t a = 0; a < 3; ++a) {
    counted.first[a] = std::max(counted.first[a], inside.first[a]);
    counted.past[a] = std::min(counted.past[a], inside.past[a]);
  }
  const SurfaceSeeds surface =
      find_surface(image, beyond, grown(window, reach, flat), counted, smoothing.sigma);
  out.report.rescued += surface.rescued;

  const Int3 n = out.window.size();
  const Int3 m = surface.window.size();
  const std::array<Index, 3> stride{1, m[0], Index{m[0]} * m[1]};
  const auto band = static_cast<float>(smoothing.band);
  for_each_nearest(surface.mark, m, reach, [&](int j, int k, const std::vector<Offset>& row) {
    const int y = window.first[1] + j;
    const int z = window.first[2] + k;
    auto* s = &out.s[static_cast<std::size_t>(
        Index{n[0]} * (y - out.window.first[1] + Index{n[1]} * (z - out.window.first[2])))];
    const auto v = static_cast<Index>(surface.at(window.first[0], y, z));
    for (int i = 0; i < static_cast<int>(row.size()); ++i) {
      const int x = window.first[0] + i;
      s[i] = distance_at(surface, stride, v + i, row[static_cast<std::size_t>(i)], band);
      if (counted.holds(x, y, z) && image.at(x, y, z) != (s[i] > 0)) {
        ++(s[i] > 0 ? out.report.flipped_grains : out.report.flipped_pores);
      }
    }
  });
}

}  // namespace

VoxelSolid smooth_solid(const VoxelView& image, Real pixel, const Surroundings& beyond,
                        Window window, const Smoothing& smoothing) {
  if (smoothing.sigma < 0.5 || smoothing.sigma > 20 || smoothing.band < 2 || smoothing.band > 400) {
    throw InputError(fmt::format(
        "smoothing of {:.3g} pixels with distances up to {:.3g} pixels: the first must be within "
        "0.5..20 (try one pixel), the second within 2..400.",
        smoothing.sigma, smoothing.band));
  }
  const bool flat = image.n[2] == 1;
  if (flat) {
    window.first[2] = 0;
    window.past[2] = 1;
  }
  VoxelSolid out{image.n, pixel, beyond, smoothing.band * pixel, window, {}, {}};
  const Int3 n = window.size();
  out.s.resize(static_cast<std::size_t>(product(n)));
  const int split = flat ? 1 : 2;
  const Index plane = product(n) / std::max(n[split], 1);
  const int thickness = static_cast<int>(
      std::clamp<Index>(piece_voxels / std::max<Index>(plane, 1), 32, std::max(n[split], 32)));
  for (int first = window.first[split]; first < window.past[split]; first += thickness) {
    Window piece = window;
    piece.first[split] = first;
    piece.past[split] = std::min(first + thickness, window.past[split]);
    fill(image, beyond, piece, smoothing, out);
  }
  return out;
}

namespace {

/// Coordinate [voxels from the first voxel of the window] of a point on one axis.
Real locate(Real x, int n, Beyond beyond, int first, int past) {
  const auto outside = [&](Real t) { return t < first || t > past - 1; };
  if (outside(x)) {
    if (beyond == Beyond::periodic) {
      for (const Real other : {x - n * std::floor((x - first) / n), x + n, x - n}) {
        if (!outside(other)) {
          x = other;
          break;
        }
      }
    } else if (beyond == Beyond::mirror) {
      for (const Real other : {-1 - x, 2 * n - 1 - x}) {
        if (!outside(other)) {
          x = other;
          break;
        }
      }
    }
  }
  return std::clamp<Real>(x - first, 0, past - 1 - first);
}

}  // namespace

Real signed_distance(const VoxelSolid& solid, const Vec3& x) {
  const Int3 n = solid.window.size();
  Int3 low{};
  std::array<float, 3> t{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    if (n[a] == 1) {
      continue;
    }
    const Real at = locate(x[axis] / solid.pixel - 0.5, solid.n[a], solid.beyond[a],
                           solid.window.first[a], solid.window.past[a]);
    low[a] = std::min(static_cast<int>(at), n[a] - 2);
    t[a] = static_cast<float>(at - low[a]);
  }
  const Index row = n[0];
  const Index plane = row * n[1];
  const float* s = &solid.s[static_cast<std::size_t>(low[0] + row * low[1] + plane * low[2])];
  const Index dx = n[0] > 1 ? 1 : 0;
  const Index dy = n[1] > 1 ? row : 0;
  const Index dz = n[2] > 1 ? plane : 0;
  const auto along_x = [&](Index v) { return s[v] + t[0] * (s[v + dx] - s[v]); };
  const auto along_y = [&](Index v) {
    const float a = along_x(v);
    return a + t[1] * (along_x(v + dy) - a);
  };
  const float a = along_y(0);
  return solid.pixel * (a + t[2] * (along_y(dz) - a));
}

}  // namespace porefines::geom
