// SPDX-License-Identifier: MPL-2.0
#include "core/signals.hpp"

#include <csignal>

#include <gtest/gtest.h>

namespace porefines {

TEST(Signals, raise_a_flag_once_and_kill_the_second_time) {
  watch_signals();
  EXPECT_EQ(caught_signal(), 0);
  std::raise(SIGTERM);
  EXPECT_EQ(caught_signal(), SIGTERM);
  EXPECT_EQ(std::signal(SIGTERM, SIG_DFL), SIG_DFL);  // what the next one would meet
  watch_signals();
  EXPECT_EQ(caught_signal(), 0);
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

}  // namespace porefines
