// SPDX-License-Identifier: MPL-2.0
#include "core/progress.hpp"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

namespace porefines {
namespace {

TEST(Progress, elsewhere_than_a_terminal_prints_few_plain_lines) {
  std::ostringstream out;
  double now = 100;
  {
    Progress progress("solve", out, false, [&] { return now; });
    for (int step = 1; step <= 100; ++step) {
      now += 0.2;
      progress.update(step / 100.0);
    }
  }
  EXPECT_EQ(out.str(),
            "solve: 15 %, 17 s left\n"  // the first after 3 s
            "solve: 30 %, 14 s left\n"
            "solve: 45 %, 11 s left\n"
            "solve: 60 %, 8 s left\n"
            "solve: 75 %, 5 s left\n"
            "solve: 90 %, 2 s left\n"
            "solve: 100 %, 20 s in all\n");
}

TEST(Progress, a_slow_loop_prints_each_tenth_once) {
  std::ostringstream out;
  double now = 0;
  Progress progress("solve", out, false, [&] { return now; });
  for (int step = 0; step < 1000; ++step) {
    now += 10;
    progress.update(step / 1000.0);
  }
  const std::string text = out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 9);
}

TEST(Progress, what_was_done_before_took_no_time_of_this_one) {
  std::ostringstream out;
  double now = 0;
  Progress progress("run", out, false, [&] { return now; });
  progress.start_from(0.6);
  now = 10;
  progress.update(0.6);
  now = 30;
  progress.update(0.7);  // a tenth in half a minute
  progress.update(0.75);
  now = 50;
  progress.update(0.8);
  EXPECT_EQ(out.str(), "run: 70 %, 1 min 30 s left\nrun: 80 %, 50 s left\n");
}

TEST(Progress, on_a_terminal_redraws_one_line) {
  std::ostringstream out;
  double now = 0;
  {
    Progress progress("solve", out, true, [&] { return now; });
    progress.update(0);
    now = 30;
    progress.update(0.5);
  }
  EXPECT_EQ(out.str(),
            "\rsolve [..............................]   0 %, time left unknown\033[K"
            "\rsolve [###############...............]  50 %, 30 s left\033[K\n");
}

TEST(Progress, on_a_terminal_does_not_redraw_at_every_step) {
  std::ostringstream out;
  double now = 0;
  Progress progress("solve", out, true, [&] { return now; });
  for (int step = 0; step < 10000; ++step) {
    now += 1e-4;
    progress.update(step / 10000.0);
  }
  const std::string text = out.str();
  EXPECT_LE(std::count(text.begin(), text.end(), '\r'), 11);
}

TEST(FormatDuration, uses_two_units_at_most) {
  EXPECT_EQ(format_duration(0.4), "0 s");
  EXPECT_EQ(format_duration(59.6), "1 min 00 s");
  EXPECT_EQ(format_duration(200), "3 min 20 s");
  EXPECT_EQ(format_duration(7500), "2 h 05 min");
  EXPECT_EQ(format_duration(4 * 86400 + 3 * 3600), "4 d 03 h");
}

}  // namespace
}  // namespace porefines
