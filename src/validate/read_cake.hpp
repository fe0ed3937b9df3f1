// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include "core/types.hpp"

namespace porefines::validate {

/// A filter cake on a sieve at the downstream end of a run, between two of its samples.
struct CakeGrowth {
  Real share =
      0;  ///< phi_m, solid in the cake: its bins a diameter away from front and sieve, both samples
  Real front = 0;       ///< [m/s] speed of the front against the flow
  Real resistance = 0;  ///< [1/m^2] of what came in between: (dp/dt) / (mu q front) = 1/k
};

/// What is fed to it.
struct CakeFeed {
  Real velocity = 0;   ///< [m/s] q, superficial
  Real viscosity = 0;  ///< [Pa s]
  Real diameter = 0;   ///< [m] of the fines
};

/// From retention.csv and series.csv of a run's output folder: the front is where the solid share falls through 0.35, seen
/// from the sieve, between bins. NaN where there is no cake.
[[nodiscard]] CakeGrowth cake_growth(const std::string& folder, const CakeFeed& feed, Real from,
                                     Real until);

/// 1/k = 180 phi^2 / ((1 - phi)^3 d^2) of equal spheres (Kozeny & Carman). [1/m^2]
[[nodiscard]] Real kozeny_carman(Real share, Real diameter);

}  // namespace porefines::validate
