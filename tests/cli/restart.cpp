// SPDX-License-Identifier: MPL-2.0
// A run that was stopped goes on as if it had not been: results byte for byte.
#include <csignal>
#include <filesystem>

#include <gtest/gtest.h>

#include "cli/run_support.hpp"
#include "core/atomic_file.hpp"

namespace porefines {
namespace {

using test::number;
using test::read_text;

/// Particles that come in, roll over a belt, collide and leave; a checkpoint after every stretch.
const std::string busy_case = R"(gravity = "9.81 m/s^2"
[run]
end_time = "20 ms"
[geometry]
kind = "empty"
size = ["2 mm", "2 mm", "2 mm"]
[box]
periodic = ["y"]
open = ["x+"]
[[particles]]
diameter = { mean = "0.2 mm", standard_deviation = "0.02 mm" }
young = "1 MPa"
count = 20
velocity = ["0.1 m/s", "0.05 m/s", "0 m/s"]
[injection]
face = "z+"
rate = "2000 Hz"
velocity = "0.1 m/s"
stop = "15 ms"
[[surface]]
kind = "plane"
point = ["0 mm", "0 mm", "0.1 mm"]
velocity = ["0.1 m/s", "0 m/s", "0 m/s"]
[contact]
max_overlap = 0.1
rolling = { model = "spring-dashpot", friction = 0.1 }
[checkpoint]
every = "1 ns"
[[output]]
kind = "tracks"
every = "1 ms"
forces = true
)";

class Restart : public ::testing::Test {
 protected:
  Restart() { write_file(folder_ / "case.toml", busy_case); }

  [[nodiscard]] std::vector<std::string> words(const std::string& out, bool restart = true,
                                               const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"run", "case.toml", "-o", out};
    if (restart) {
      all.emplace_back("--restart");
    }
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  test::ProgramResult run(const std::vector<std::string>& arguments) const {
    return test::porefines_in(folder_.path(), arguments);
  }
  /// Starts, and sends a signal in the middle.
  test::ProgramResult stop_with(int signal) const {
    std::vector<std::string> command = words("out", false);
    command.insert(command.begin(), PF_BINARY);
    test::Background running(folder_.path(), command);
    EXPECT_TRUE(running.wait_for("checkpoint at 0.008 s")) << running.end().output;
    running.send(signal);
    return running.end();
  }

  test::Scratch folder_;
};

TEST_F(Restart, after_kill_and_after_sigterm_results_are_byte_for_byte_those_of_one_run) {
  const auto whole = run(words("whole", false));
  ASSERT_EQ(whole.exit_code, 0) << whole.output;
  const std::string summary = read_text(folder_ / "whole/summary.json");
  EXPECT_EQ(number(summary, "particles_injected"), 50);
  EXPECT_GT(number(summary, "particles_out"), 0);
  for (const int signal : {SIGKILL, SIGTERM}) {
    const auto stopped = stop_with(signal);
    EXPECT_EQ(stopped.exit_code, 128 + signal) << stopped.output;
    EXPECT_EQ(std::filesystem::exists(folder_ / "out/summary.json"), signal == SIGTERM);
    const auto resumed = run(words("out"));
    ASSERT_EQ(resumed.exit_code, 0) << resumed.output;
    for (const std::string table : {"tracks.csv", "series.csv"}) {
      EXPECT_EQ(read_text(folder_ / ("out/" + table)), read_text(folder_ / ("whole/" + table)));
    }
    const std::string now = read_text(folder_ / "out/summary.json");
    for (const std::string key : {"particles_out", "kinetic_j", "max_overlap", "elastic_j"}) {
      EXPECT_EQ(number(now, key), number(summary, key)) << key;
    }
  }
}

TEST_F(Restart, goes_on_with_other_ranks_and_to_a_later_end) {
  ASSERT_EQ(run(words("one", false, {"run.end_time=10 ms"})).exit_code, 0);
  std::filesystem::copy(folder_ / "one", folder_ / "two");
  ASSERT_EQ(run(words("one", true, {"run.end_time=12 ms"})).exit_code, 0);
  std::vector<std::string> command = words("two", true, {"run.end_time=12 ms"});
  command.insert(command.begin(), {"mpirun", "--oversubscribe", "-n", "2", PF_BINARY});
  const auto two = test::run_in(folder_.path(), command);
  ASSERT_EQ(two.exit_code, 0) << two.output;
  const std::string a = read_text(folder_ / "one/summary.json");
  const std::string b = read_text(folder_ / "two/summary.json");
  EXPECT_EQ(number(a, "time_s"), 0.012);
  EXPECT_EQ(number(a, "particles_inside"), number(b, "particles_inside"));
  EXPECT_NEAR(number(b, "kinetic_j") / number(a, "kinetic_j"), 1, 1e-9);
  EXPECT_NEAR(number(b, "max_overlap") / number(a, "max_overlap"), 1, 1e-9);
}

TEST_F(Restart, refuses_what_it_cannot_continue) {
  const auto nothing = run(words("out"));
  EXPECT_EQ(nothing.exit_code, 2) << nothing.output;
  EXPECT_NE(nothing.output.find("out/checkpoint.h5: there is no checkpoint"), std::string::npos);
  ASSERT_EQ(run(words("out", false, {"run.end_time=1 ms"})).exit_code, 0);
  const auto other = run(words("out", true, {"contact.restitution=0.7"}));
  EXPECT_EQ(other.exit_code, 2) << other.output;
  EXPECT_NE(other.output.find("then: contact.restitution = 0.5\nnow:  contact.restitution = 0.7"),
            std::string::npos)
      << other.output;
}

/// A limit on the size of files stands in for the full disk; the run is at work when it comes.
TEST_F(Restart, a_checkpoint_that_finds_no_room_is_a_warning) {
  test::Background running(
      folder_.path(), {PF_BINARY, "run", "case.toml", "run.end_time=1 day", "checkpoint.every=1 h",
                       "output=[{ kind = \"summary\", every = \"1 day\" }]"});
  ASSERT_TRUE(running.wait_for("of memory")) << running.end().output;
  running.limit_files(60000);
  running.send(SIGTERM);
  const test::ProgramResult result = running.end();
  EXPECT_EQ(result.exit_code, 128 + SIGTERM) << result.output;
  EXPECT_NE(result.output.find("MB of a checkpoint: File too large"), std::string::npos)
      << result.output;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/checkpoint.h5"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/checkpoint.h5.part"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/summary.json"));
}

}  // namespace
}  // namespace porefines
