// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/types.hpp"
#include "geom/random.hpp"

namespace porefines::geom {

/// Smooth noise in -1..1: values on a hashed lattice, quintic interpolation (Perlin 2002).
class Noise {
 public:
  /// @param size        [pixels] of the picture along x and y
  /// @param wavelength  [pixels] rounded so that a whole number fits into the picture
  /// @param key         another key, another noise
  Noise(const Int3& size, bool periodic, Real wavelength, std::uint64_t key)
      : key_(static_cast<std::uint64_t>(hash_uniform(key) * 0x1.0p52)), periodic_(periodic) {
    for (std::size_t a = 0; a < 2; ++a) {
      cells_[a] = std::max(static_cast<int>(std::lround(size[a] / wavelength)), 1);
      scale_[a] = cells_[a] / static_cast<Real>(size[a]);
    }
  }

  [[nodiscard]] Real operator()(Real x, Real y) const {
    const Real u = x * scale_[0];
    const Real v = y * scale_[1];
    const int i = static_cast<int>(std::floor(u));
    const int j = static_cast<int>(std::floor(v));
    const Real s = ease(u - i);
    const Real t = ease(v - j);
    return (1 - t) * ((1 - s) * at(i, j) + s * at(i + 1, j)) +
           t * ((1 - s) * at(i, j + 1) + s * at(i + 1, j + 1));
  }

 private:
  static Real ease(Real t) { return t * t * t * (t * (6 * t - 15) + 10); }
  [[nodiscard]] Real at(int i, int j) const {
    if (periodic_) {
      i = ((i % cells_[0]) + cells_[0]) % cells_[0];
      j = ((j % cells_[1]) + cells_[1]) % cells_[1];
    }
    const auto place = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(i)) << 32) |
                       static_cast<std::uint32_t>(j);
    return 2 * hash_uniform(key_ ^ place) - 1;
  }
  std::uint64_t key_;
  bool periodic_;
  std::array<int, 2> cells_{};
  std::array<Real, 2> scale_{};
};

}  // namespace porefines::geom
