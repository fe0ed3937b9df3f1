// SPDX-License-Identifier: MPL-2.0
// Algebra of six numbers: translation and rotation of a sphere.
#pragma once

#include <array>

#include "core/types.hpp"

namespace porefines {

/// Translation and rotation of a rigid sphere, or force and torque on it: (x, y, z, about x, y, z).
using Six = std::array<Real, 6>;
/// Row by row.
using SixBySix = std::array<Real, 36>;

[[nodiscard]] inline Six sum_of(Six a, const Six& b) {
  for (std::size_t x = 0; x < a.size(); ++x) {
    a[x] += b[x];
  }
  return a;
}
[[nodiscard]] inline Real dot(const Six& a, const Six& b) {
  Real sum = 0;
  for (std::size_t x = 0; x < a.size(); ++x) {
    sum += a[x] * b[x];
  }
  return sum;
}
/// How much of each motion (U, omega) a velocity component has at `arm` from the centre: U + omega x arm.
[[nodiscard]] inline Six row_of(int component, const Vec3& arm) {
  Six row{};
  const int a = (component + 1) % 3;
  const int b = (component + 2) % 3;
  row[static_cast<std::size_t>(component)] = 1;
  row[static_cast<std::size_t>(3 + a)] = arm[b];
  row[static_cast<std::size_t>(3 + b)] = -arm[a];
  return row;
}
[[nodiscard]] Six times(const SixBySix& a, const Six& x);

/// L of a symmetric positive matrix A = L L^T. A semi-definite one (a sphere almost outside the grid)
/// is made definite by `ridge` times its trace.
[[nodiscard]] SixBySix cholesky(SixBySix a, Real ridge = 1e-9);
/// x of L x = b and of L^T x = b.
[[nodiscard]] Six solve_lower(const SixBySix& lower, Six b);
[[nodiscard]] Six solve_upper(const SixBySix& lower, Six b);
/// x of L L^T x = b.
[[nodiscard]] Six solved(const SixBySix& lower, const Six& b);
[[nodiscard]] SixBySix inverse_from(const SixBySix& lower);

}  // namespace porefines
