// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include "core/types.hpp"

namespace porefines::validate {

/// What mobility/known.hpp is asked for.
struct Measurement {
  std::string what;  ///< wall, along_wall, tube, approach, together, turn, shear, intrinsic
  int size = 6;      ///< [cells] of a diameter
  Real at = 0;       ///< height, ratio or distance [radii]
  Real exact = 1;    ///< of `approach`, whose mean is over it
};

/// Solves and writes FOLDER/summary.json. The job of a comparison that no case file can say.
/// @throws InputError  `what` is none of them
void measure(const Measurement& asked, const std::string& folder);

}  // namespace porefines::validate
