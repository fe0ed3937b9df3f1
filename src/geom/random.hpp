// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <numbers>
#include <random>

#include "core/types.hpp"

namespace porefines::geom {

/// Random numbers that are the same on every platform: std::mt19937_64 is fixed by the standard,
/// its distributions are not, so these are our own.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, 1).
  Real uniform() { return static_cast<Real>(engine_() >> 11) * 0x1.0p-53; }
  Real uniform(Real low, Real high) { return low + (high - low) * uniform(); }
  /// Mean 0, standard deviation 1 (Box & Muller).
  Real normal() {
    const Real r = std::sqrt(-2 * std::log(1 - uniform()));
    return r * std::cos(2 * std::numbers::pi * uniform());
  }
  /// Lognormal with the given mean; spread = standard deviation / mean.
  Real lognormal(Real mean, Real spread) {
    const Real s2 = std::log(1 + spread * spread);
    return mean * std::exp(std::sqrt(s2) * normal() - 0.5 * s2);
  }

 private:
  std::mt19937_64 engine_;
};

/// Uniform in [0, 1) from a key: the same number for the same key, in any order.
[[nodiscard]] inline Real hash_uniform(std::uint64_t key) {
  key += 0x9E3779B97F4A7C15ULL;  // splitmix64 (Steele, Lea & Flood 2014)
  key = (key ^ (key >> 30)) * 0xBF58476D1CE4E5B9ULL;
  key = (key ^ (key >> 27)) * 0x94D049BB133111EBULL;
  return static_cast<Real>((key ^ (key >> 31)) >> 11) * 0x1.0p-53;
}

}  // namespace porefines::geom
