// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "core/types.hpp"

namespace porefines::sim {

/// Every particle that was ever in the run is inside or went out through an open face.
struct Ledger {
  Index placed = 0;    ///< at the start
  Index injected = 0;  ///< since then
  Index out = 0;

  [[nodiscard]] Index expected_inside() const { return placed + injected - out; }

  /// @throws RunError  when particles were lost or came from nowhere. Test: unit/ledger.
  void require_balance(Index inside, Real time) const;
};

}  // namespace porefines::sim
