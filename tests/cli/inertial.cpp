// SPDX-License-Identifier: MPL-2.0
// Runs with inertia from their case files.
#include <csignal>
#include <filesystem>

#include <gtest/gtest.h>

#include "cli/run_support.hpp"
#include "core/atomic_file.hpp"

namespace porefines::test {
namespace {

/// A cylinder of eight cells in a stream, started askew.
const std::string stream_case = R"([run]
end_time = "0.8 ms"
[geometry]
kind = "cylinders"
source = "cylinder.txt"
size = ["1.6 mm", "1.2 mm", "25 um"]
list_unit = "1 mm"
periodic_images = false
[grid]
cell_size = "25 um"
[fluid]
density = "1000 kg/m^3"
viscosity = "1 mPa s"
[flow]
regime = "navier-stokes"
inlet = { face = "x-", velocity = "0.5 m/s" }
outlet = { face = "x+", pressure = "5 Pa" }
slip = ["y-", "y+", "z-", "z+"]
reservoir = "0 m"
disturbance = 0.1
[checkpoint]
every = "1 ns"
[[output]]
kind = "summary"
every = "0.1 ms"
[[probe]]
name = "wake"
position = ["1 mm", "0.6 mm", "10 um"]
)";

class Inertial : public ::testing::Test {
 protected:
  Inertial() {
    write_file(folder_ / "case.toml", stream_case);
    write_file(folder_ / "cylinder.txt", "0.5 0.6 0.1\n");
  }
  [[nodiscard]] ProgramResult run(const std::vector<std::string>& more, int ranks = 1) const {
    std::vector<std::string> words{PF_BINARY, "run", "case.toml"};
    words.insert(words.end(), more.begin(), more.end());
    return run_on(ranks, folder_, words);
  }
  [[nodiscard]] std::string text(const std::string& name) const {
    return read_text(folder_ / name);
  }
  Scratch folder_;
};

TEST_F(Inertial, goes_on_after_sigterm_bit_for_bit_and_on_two_ranks) {
  const auto whole = run({"-o", "whole"});
  ASSERT_EQ(whole.exit_code, 0) << whole.output;
  Background running(folder_.path(), {PF_BINARY, "run", "case.toml", "-o", "out"});
  ASSERT_TRUE(running.wait_for("step 5")) << running.end().output;
  running.send(SIGTERM);
  EXPECT_EQ(running.end().exit_code, 128 + SIGTERM);
  EXPECT_EQ(text("out/summary.json").find("\"done\""), std::string::npos);
  std::filesystem::copy(folder_ / "out", folder_ / "two");
  const auto resumed = run({"-o", "out", "--restart"});
  ASSERT_EQ(resumed.exit_code, 0) << resumed.output;
  EXPECT_EQ(text("out/series.csv"), text("whole/series.csv"));
  const std::string alone = text("whole/summary.json");
  EXPECT_EQ(number(text("out/summary.json"), "body_1_force_x_n"),
            number(alone, "body_1_force_x_n"));

  const auto two = run({"-o", "two", "--restart"}, 2);
  ASSERT_EQ(two.exit_code, 0) << two.output;
  const std::string together = text("two/summary.json");
  for (const std::string key : {"body_1_force_x_n", "body_1_force_y_n", "kinetic_energy_j"}) {
    EXPECT_NEAR(number(together, key) / number(alone, key), 1, 1e-4) << key;
  }
  const Csv series = read_csv(folder_ / "whole/series.csv");
  EXPECT_LE(series.at(series.rows.size() - 1, "courant"), 0.9);
  EXPECT_NE(series.at(series.rows.size() - 1, "probe_wake_velocity_x_m_s"), 0);
  EXPECT_NEAR(series.at(series.rows.size() - 1, "mean_velocity_x_m_s"), 0.5, 1e-5);
}

/// At Re 10 in a narrow stream; drag is what the pressures and the momentum at the openings leave.
TEST_F(Inertial, finds_the_steady_flow) {
  const auto found = run({"-o", "out", "flow.steady=true", "flow.inlet.velocity=0.05 m/s",
                          "output=[{ kind = \"fields\" }, { kind = \"pictures\" }]"});
  ASSERT_EQ(found.exit_code, 0) << found.output;
  const std::string summary = text("out/summary.json");
  EXPECT_NEAR(number(summary, "reynolds_body"), 10, 1e-9);
  EXPECT_GT(number(summary, "body_1_drag_coefficient"), 3);  // 2.98 in a domain four times as wide
  EXPECT_LT(number(summary, "body_1_drag_coefficient"), 6);
  EXPECT_NEAR(number(summary, "body_1_lift_coefficient"), 0, 1e-3);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/fields.xdmf"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/speed.png"));
}

/// 0.05 m/s through 1.2 mm x 25 um.
TEST_F(Inertial, keeps_a_flow_rate) {
  const auto found = run({"-o", "out", "flow.steady=true", "flow.reservoir=0.1 mm",
                          "flow.inlet={ face = \"x-\", flow_rate = \"1.5e-9 m^3/s\" }"});
  ASSERT_EQ(found.exit_code, 0) << found.output;
  EXPECT_NEAR(number(text("out/summary.json"), "flow_rate_m3_s") / 1.5e-9, 1, 1e-5);
  EXPECT_NEAR(number(text("out/summary.json"), "reynolds_body"), 10, 1e-6);
}

TEST_F(Inertial, says_what_it_cannot_do) {
  const auto refused = [&](const std::string& change) {
    const auto result = run({"-o", "out", change});
    EXPECT_EQ(result.exit_code, 2) << result.output;
    return result.output;
  };
  EXPECT_NE(refused("flow.inlet={ face = \"x-\", flow_rate = \"1 mL/s\" }").find("give a velocity"),
            std::string::npos);
  EXPECT_NE(refused("flow.courant=100").find("courant"), std::string::npos);
}

}  // namespace
}  // namespace porefines::test
