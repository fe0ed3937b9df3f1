// SPDX-License-Identifier: MPL-2.0
#include "geom/pore_size.hpp"

#include <algorithm>
#include <numbers>

namespace porefines::geom {

VoxelSolid whole_solid(const VoxelView& image, Real pixel, Surroundings beyond, Real sigma) {
  constexpr Real most = 400;
  for (Beyond& side : beyond) {
    side = side == Beyond::pore ? Beyond::mirror : side;
  }
  const Real enough_in_grains = image.n[2] == 1 ? most : 29;
  for (Real band = 14.5;; band = std::min(2 * band, most)) {
    VoxelSolid solid = smooth_solid(image, pixel, beyond, {{0, 0, 0}, image.n}, {sigma, band});
    const auto [grain, pore] = std::minmax_element(solid.s.begin(), solid.s.end());
    const auto limit = static_cast<float>(band) - 0.5F;
    if ((*pore < limit && (-*grain < limit || band >= enough_in_grains)) || band >= most) {
      return solid;
    }
  }
}

namespace {

/// Draw a ball of radius r [pixels] around voxel x: values become at least `value`.
void draw_ball(std::vector<float>& to, const Int3& n, const Int3& x, float r, float value) {
  const float reach = r + 0.5F;
  const int rz = n[2] == 1 ? 0 : static_cast<int>(reach);
  for (int dz = std::max(-rz, -x[2]); dz <= std::min(rz, n[2] - 1 - x[2]); ++dz) {
    const float left = reach * reach - static_cast<float>(dz * dz);
    const int ry = static_cast<int>(std::sqrt(std::max(left, 0.0F)));
    for (int dy = std::max(-ry, -x[1]); dy <= std::min(ry, n[1] - 1 - x[1]); ++dy) {
      const int rx =
          static_cast<int>(std::sqrt(std::max(left - static_cast<float>(dy * dy), 0.0F)));
      float* const row = &to[static_cast<std::size_t>(voxel_index(n, 0, x[1] + dy, x[2] + dz))];
      const int past = std::min(x[0] + rx + 1, n[0]);
      for (int i = std::max(x[0] - rx, 0); i < past; ++i) {
        row[i] = std::max(row[i], value);
      }
    }
  }
}

}  // namespace

float ridge_gain(const VoxelSolid& solid, Index v) {
  const std::array<Index, 3> stride{1, solid.n[0], Index{solid.n[0]} * solid.n[1]};
  const auto at = [&](Index u) { return solid.s[static_cast<std::size_t>(u)]; };
  float gain = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const Index x = v / stride[a] % solid.n[a];
    if (x > 0 && x < solid.n[a] - 1) {
      const float d = at(v + stride[a]) + at(v - stride[a]) - 2 * at(v);
      gain = std::max(gain, std::min(-0.5F * d, 1 + 0.5F * d));
    }
  }
  return gain;
}

std::vector<float> local_thickness(const VoxelSolid& solid) {
  const Int3 n = solid.n;
  std::vector<float> thickness(solid.s.size(), 0);
  const auto at = [&](Index v) { return solid.s[static_cast<std::size_t>(v)]; };
  for (Index v = 0; v < product(n); ++v) {
    const float r = at(v);
    if (r <= 0) {
      continue;
    }
    const Int3 x{static_cast<int>(v % n[0]), static_cast<int>(v / n[0] % n[1]),
                 static_cast<int>(v / (Index{n[0]} * n[1]))};
    bool contained = false;  // a neighbour's ball reaches (nearly) as far on all sides
    for (int a = 0; a < 27 && !contained; ++a) {
      const Int3 d{a % 3 - 1, a / 3 % 3 - 1, a / 9 - 1};
      const Int3 y{x[0] + d[0], x[1] + d[1], x[2] + d[2]};
      const int steps = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
      if (steps > 0 && y[0] >= 0 && y[1] >= 0 && y[2] >= 0 && y[0] < n[0] && y[1] < n[1] &&
          y[2] < n[2]) {
        constexpr std::array<float, 4> climb{0, 0.9F, 0.9F * 1.41421F, 0.9F * 1.73205F};
        contained =
            at(voxel_index(n, y[0], y[1], y[2])) >= r + climb[static_cast<std::size_t>(steps)];
      }
    }
    if (!contained) {
      draw_ball(thickness, n, x, r, 2 * (r + ridge_gain(solid, v)));
    }
  }
  for (std::size_t v = 0; v < thickness.size(); ++v) {
    thickness[v] = solid.s[v] > 0 ? std::max(thickness[v], 2 * solid.s[v]) : 0;
  }
  return thickness;
}

Real surface_area(const VoxelSolid& solid, Real depth) {
  constexpr Real e = 1.5;
  const Int3 n = solid.n;
  const std::array<Index, 3> stride{1, n[0], Index{n[0]} * n[1]};
  Real sum = 0;
  for (Index v = 0; v < product(n); ++v) {
    const Real s = solid.s[static_cast<std::size_t>(v)];
    if (std::abs(s) >= e) {
      continue;
    }
    Real square = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      const Index i = v / stride[a] % n[a];
      const Index up = i + 1 < n[a] ? v + stride[a] : v;
      const Index down = i > 0 ? v - stride[a] : v;
      if (up != down) {
        const Real g = (static_cast<Real>(solid.s[static_cast<std::size_t>(up)]) -
                        solid.s[static_cast<std::size_t>(down)]) /
                       static_cast<Real>(up - down) * static_cast<Real>(stride[a]);
        square += g * g;
      }
    }
    sum += (1 + std::cos(std::numbers::pi * s / e)) / (2 * e) * std::sqrt(square);
  }
  return sum * solid.pixel * (n[2] == 1 ? depth : solid.pixel);
}

}  // namespace porefines::geom
