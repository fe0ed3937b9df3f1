// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <span>

#include "core/types.hpp"

namespace porefines::analysis {

/// What a body in a stream feels in the later half of a record.
struct Shedding {
  Real drag = 0;       ///< mean over whole periods; without any, over the last quarter
  Real lift = 0;       ///< half of the lift from its lowest to its highest value
  Real frequency = 0;  ///< [1/s] of the lift; 0: less than two periods
  int periods = 0;
};

/// Frequency from upward crossings of the lift through its mean, interpolated between samples.
/// Lift below a thousandth of the drag counts as none.
/// @param time  [s] increasing; drag and lift in any unit
/// Test: unit/shedding.
[[nodiscard]] Shedding find_shedding(std::span<const Real> time, std::span<const Real> drag,
                                     std::span<const Real> lift);

}  // namespace porefines::analysis
