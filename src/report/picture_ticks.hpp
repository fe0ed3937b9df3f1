// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

#include "core/types.hpp"

namespace porefines::report {

/// How numbers of one size are shown: value / factor, followed by the unit.
struct DisplayUnit {
  Real factor = 1;   ///< in SI; 1e-6 for "µm/s"
  std::string text;  ///< "µm/s", or "10^-6 1/s" where the unit takes no prefix
};

/// Prefix in steps of a thousand for values up to `largest`; `unit` is SI, e.g. "m/s", "Pa".
/// Units that take no simple prefix ("m^2", "1/s", "kg/m^3", "") get a power of ten instead.
[[nodiscard]] DisplayUnit display_unit(Real largest, const std::string& unit);

/// Multiples of 1, 2 or 5 times a power of ten within [low, high]; about `wanted` of them.
[[nodiscard]] std::vector<Real> nice_ticks(Real low, Real high, int wanted);

/// Largest 1, 2 or 5 times a power of ten that is at most `value` > 0.
[[nodiscard]] Real nice_below(Real value);

/// Shortest decimal text of a tick that lies on a grid of `step`: "0.25", "-3", "0".
[[nodiscard]] std::string tick_text(Real value, Real step);

}  // namespace porefines::report
