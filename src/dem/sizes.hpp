// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <variant>
#include <vector>

#include "core/random.hpp"

namespace porefines::dem {

struct Mono {};

/// A normal distribution of diameters, cut at both ends.
struct NormalLaw {
  Real deviation = 0;  ///< [m] before it is cut
};

/// A lognormal distribution; mean and deviation are those of the diameter before it is cut.
struct LognormalLaw {
  Real deviation = 0;  ///< [m]
};

/// A few diameters and their shares.
struct TableLaw {
  std::vector<Real> diameter;  ///< [m]
  std::vector<Real> share;     ///< sums to 1
};

/// How the diameters of a species are distributed.
///
/// `by_volume`: the law is that of the volume of particles, as a sieve curve gives it. Their number
/// then follows f(d) / d^3: of a volume-weighted lognormal that is a lognormal with the same width
/// and a median smaller by exp(-3 s^2).
struct Sizes {
  Real mean = 0;      ///< [m]
  Real smallest = 0;  ///< [m] normal and lognormal end here
  Real largest = 0;   ///< [m]
  std::variant<Mono, NormalLaw, LognormalLaw, TableLaw> law;
  bool by_volume = false;
};

/// A diameter [m]: exact, by rejection. Tests: unit/dem_sizes.
[[nodiscard]] Real draw_diameter(const Sizes& sizes, Draws& draws);

/// Mean of d^power [m^power] over the number of particles, by quadrature to 1e-6.
[[nodiscard]] Real mean_power(const Sizes& sizes, int power);

/// [m^3] pi/6 mean d^3.
[[nodiscard]] Real mean_volume(const Sizes& sizes);

[[nodiscard]] Real smallest_diameter(const Sizes& sizes);
[[nodiscard]] Real largest_diameter(const Sizes& sizes);

}  // namespace porefines::dem
