// SPDX-License-Identifier: MPL-2.0
// A batch system's warning: leave between two stages or cycles, with nothing that looks like a result.
#include <csignal>
#include <filesystem>

#include <gtest/gtest.h>

#include "cli/run_support.hpp"
#include "core/atomic_file.hpp"

namespace porefines {
namespace {

constexpr int terminated = 128 + SIGTERM;

class Signal : public ::testing::Test {
 protected:
  Signal() { write_file(folder_ / "chip.toml", test::chip_case); }

  /// A run that ends by nothing but a signal: doubles cannot hold a residual of 1e-14 here, and
  /// 100,000 cycles take hours.
  [[nodiscard]] test::Background endless_run() const {
    return {folder_.path(),
            {PF_BINARY, "run", "chip.toml", "grid.cells=[128, 64, 64]", "flow.tolerance=1e-14",
             "flow.max_cycles=100000"}};
  }

  void expect_no_results() const {
    for (const std::string file : {"summary.json", "fields.xdmf", "speed.png"}) {
      EXPECT_FALSE(std::filesystem::exists(folder_ / ("out/" + file))) << file;
    }
  }

  void expect_proper_end(test::Background& run) const {
    const test::ProgramResult result = run.end();
    EXPECT_EQ(result.exit_code, terminated) << result.output;
    EXPECT_NE(result.output.find("stopped by signal 15"), std::string::npos) << result.output;
    expect_no_results();
  }

  test::Scratch folder_;
};

TEST_F(Signal, ends_a_solve_between_two_cycles) {
  test::Background run = endless_run();
  ASSERT_TRUE(run.wait_for("set-up")) << run.end().output;
  run.send(SIGTERM);
  expect_proper_end(run);
}

TEST_F(Signal, ends_the_set_up) {
  test::Background run = endless_run();
  ASSERT_TRUE(run.wait_for("porefines")) << run.end().output;
  run.send(SIGTERM);
  expect_proper_end(run);
}

/// Before the program can react there is nothing to save: it dies as any program.
TEST_F(Signal, as_early_as_can_be_ends_it_too) {
  test::Background run = endless_run();
  run.send(SIGTERM);
  const test::ProgramResult result = run.end();
  EXPECT_EQ(result.exit_code, terminated) << result.output;
  expect_no_results();
}

}  // namespace
}  // namespace porefines
