// SPDX-License-Identifier: MPL-2.0
#pragma once

namespace porefines {

/// From here on SIGINT and SIGTERM only raise a flag, so that the loop can save its state and leave.
/// A second signal of the same kind ends the process at once, as without porefines.
/// Called once, first thing in a command that looks at the flag; the others just die.
void watch_signals();

/// The signal that came since watch_signals(), or 0. Each rank sees its own: reduce before acting.
[[nodiscard]] int caught_signal();

/// Leaves a command because of a signal, on every rank at once.
struct Interrupted {
  int signal = 0;
};

}  // namespace porefines
