// SPDX-License-Identifier: MPL-2.0
#include "sim/ledger.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace porefines::sim {

void Ledger::require_balance(Index inside, Real time) const {
  if (inside == expected_inside()) {
    return;
  }
  throw RunError(fmt::format(
      "the ledger does not balance at {:.6g} s: {} placed + {} injected - {} out = {}, but {} are "
      "inside\nparticles were {}: this is a defect of porefines, please report it with the case",
      time, placed, injected, out, expected_inside(), inside,
      inside < expected_inside() ? "lost" : "gained"));
}

}  // namespace porefines::sim
