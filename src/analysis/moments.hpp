// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/types.hpp"

namespace porefines::analysis {

/// Sums over particles from which mean speed and spread follow; summed over ranks as plain numbers.
struct MomentSums {
  std::array<Real, 8> values{};  ///< count, |v|, x, y, z, x^2, y^2, z^2

  void add(const Vec3& position, const Vec3& velocity) {
    values[0] += 1;
    values[1] += norm(velocity);
    for (int a = 0; a < 3; ++a) {
      values[2 + a] += position[a];
      values[5 + a] += position[a] * position[a];
    }
  }
};

/// Where the particles are and how far they spread.
struct Moments {
  Real mean_speed = 0;  ///< [m/s]
  Vec3 mean;            ///< [m]
  Vec3 sigma;           ///< [m] sqrt(sum (x - mean)^2 / N), thesis eq. 19
};

/// Zeros when there are no particles. Test: unit/run_readings.
[[nodiscard]] inline Moments moments_of(const MomentSums& sums) {
  const Real count = std::max<Real>(sums.values[0], 1);
  Moments out;
  out.mean_speed = sums.values[1] / count;
  for (int a = 0; a < 3; ++a) {
    out.mean[a] = sums.values[2 + a] / count;
    const Real square = sums.values[5 + a] / count - out.mean[a] * out.mean[a];
    out.sigma[a] = std::sqrt(std::max(square, 0.0));
  }
  return out;
}

}  // namespace porefines::analysis
