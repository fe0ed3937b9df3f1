// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <cstdint>

#include "core/types.hpp"

namespace porefines {

/// Ten rounds of Philox 4x32: a bijection of the 128-bit counter that the key chooses.
///
/// Source: Salmon, Moraes, Dror & Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC11 (2011).
/// Test: unit/random (the authors' known answers).
[[nodiscard]] std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                                  std::array<std::uint32_t, 2> key);

/// What a sequence of random numbers is for: the same particle draws its size and its place apart.
enum class Stream : std::uint32_t {
  size = 1,
  place = 2,
  packing = 3,
  brownian = 4,
  motion = 5,
  bootstrap = 6
};

/// The random numbers that belong to (seed, stream, id): the n-th is always the same, whoever asks,
/// on any number of ranks and in any order. Its whole state is how many were drawn.
class Draws {
 public:
  /// @param id  usually that of a particle
  Draws(std::uint64_t seed, Stream stream, std::uint64_t id, std::uint32_t drawn = 0);

  /// Uniform in [0, 1): 53 bits.
  [[nodiscard]] Real uniform();
  [[nodiscard]] Real uniform(Real low, Real high) { return low + (high - low) * uniform(); }
  /// Mean 0, standard deviation 1 (Box & Muller 1958); takes two uniforms.
  [[nodiscard]] Real normal();
  /// exp of a normal, such that the mean and the standard deviation are these.
  [[nodiscard]] Real lognormal(Real mean, Real standard_deviation);
  /// Number of events where `mean` are expected. Cost: proportional to the mean.
  [[nodiscard]] std::int64_t poisson(Real mean);
  /// A direction, uniform on the sphere.
  [[nodiscard]] Vec3 direction();

  [[nodiscard]] std::uint32_t drawn() const { return drawn_; }

 private:
  std::array<std::uint32_t, 2> key_;
  std::array<std::uint32_t, 4> counter_;
  std::uint32_t drawn_;
};

/// Mean and standard deviation of the logarithm of a lognormal variable.
///
///     s^2 = ln(1 + (sd / mean)^2),   m = ln mean - s^2 / 2
[[nodiscard]] std::array<Real, 2> lognormal_parameters(Real mean, Real standard_deviation);

}  // namespace porefines
