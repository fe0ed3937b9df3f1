// SPDX-License-Identifier: MPL-2.0
#include "core/signals.hpp"

#include <csignal>

namespace porefines {
namespace {

// A handler can reach nothing but a global of this type.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
volatile std::sig_atomic_t signal_flag = 0;

void remember(int number) {
  signal_flag = number;
  std::signal(number, SIG_DFL);
}

}  // namespace

void watch_signals() {
  signal_flag = 0;
  std::signal(SIGINT, remember);
  std::signal(SIGTERM, remember);
  std::signal(SIGXFSZ,
              SIG_IGN);  // a limit on file sizes is an error of the write, like a full disk
}

int caught_signal() {
  return signal_flag;
}

}  // namespace porefines
