// SPDX-License-Identifier: MPL-2.0
// Particles with mass in a flow with inertia, from the case file to the results.
#include <algorithm>
#include <csignal>
#include <filesystem>

#include <gtest/gtest.h>

#include "cli/run_support.hpp"
#include "core/atomic_file.hpp"

namespace porefines::test {
namespace {

/// A sphere of six cells falls onto the bottom of a box.
const std::string falling_case = R"(gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]
[run]
end_time = "13 ms"
[geometry]
kind = "empty"
size = ["5 mm", "5 mm", "6 mm"]
[grid]
cell_size = "0.25 mm"
[fluid]
viscosity = "5 mPa s"
[flow]
regime = "navier-stokes"
walls = ["x-", "x+", "y-", "y+", "z-", "z+"]
[contact]
restitution = 0.9
[[particles]]
source = "sphere.csv"
density = "7800 kg/m^3"
young = "1 GPa"
[checkpoint]
every = "1 ns"
[[output]]
kind = "tracks"
every = "0.5 ms"
[[output]]
kind = "summary"
every = "0.5 ms"
)";

class CoupledInertia : public ::testing::Test {
 protected:
  CoupledInertia() {
    write_file(folder_ / "case.toml", falling_case);
    write_file(folder_ / "sphere.csv",
               "x_m,y_m,z_m,diameter_m,u_m_s,v_m_s,w_m_s\n"
               "2.51e-3,2.53e-3,2.3e-3,1.5e-3,0,0,-0.2\n");
  }
  [[nodiscard]] ProgramResult run(const std::vector<std::string>& more, int ranks = 1) const {
    std::vector<std::string> words{PF_BINARY, "run", "case.toml"};
    words.insert(words.end(), more.begin(), more.end());
    return run_on(ranks, folder_, words);
  }
  [[nodiscard]] std::string text(const std::string& name) const {
    return read_text(folder_ / name);
  }
  /// Fastest speeds [m/s] down and, after that, up.
  struct Impact {
    double down = 0;
    double up = 0;
  };
  [[nodiscard]] Impact impact(const std::string& out) const {
    const Csv tracks = read_csv(folder_ / (out + "/tracks.csv"));
    Impact found;
    for (std::size_t i = 0; i < tracks.rows.size(); ++i) {
      const double w = tracks.at(i, "w_m_s");
      found.up = -w > found.down ? 0 : std::max(found.up, w);
      found.down = std::max(found.down, -w);
    }
    return found;
  }
  Scratch folder_;
};

TEST_F(CoupledInertia, goes_on_after_sigterm_bit_for_bit_and_on_two_ranks) {
  const auto whole = run({"-o", "whole"});
  ASSERT_EQ(whole.exit_code, 0) << whole.output;
  Background running(folder_.path(), {PF_BINARY, "run", "case.toml", "-o", "out"});
  ASSERT_TRUE(running.wait_for("checkpoint at 0.00")) << running.end().output;
  running.send(SIGTERM);
  EXPECT_EQ(running.end().exit_code, 128 + SIGTERM);
  std::filesystem::copy(folder_ / "out", folder_ / "two");
  const auto resumed = run({"-o", "out", "--restart"});
  ASSERT_EQ(resumed.exit_code, 0) << resumed.output;
  for (const std::string table : {"tracks.csv", "series.csv"}) {
    EXPECT_EQ(text("out/" + table), text("whole/" + table));
  }
  const auto two = run({"-o", "two", "--restart"}, 2);
  ASSERT_EQ(two.exit_code, 0) << two.output;
  EXPECT_NEAR(impact("two").up / impact("whole").up, 1, 0.01);
}

/// Stokes number 50: most of the speed comes back; 2: the liquid takes all of it. The contact alone, without
/// its liquid, would give back 0.9 of it.
TEST_F(CoupledInertia, rebounds_as_its_stokes_number_allows) {
  ASSERT_EQ(run({"-o", "thin"}).exit_code, 0);
  const Impact thin = impact("thin");
  EXPECT_GT(thin.up / thin.down, 0.2);
  EXPECT_LT(thin.up / thin.down, 0.9);
  ASSERT_EQ(run({"-o", "thick", "fluid.viscosity=150 mPa s"}).exit_code, 0);
  const Impact thick = impact("thick");
  EXPECT_LT(thick.up / thick.down, 0.01);
}

/// Neither weight nor drive tells the speed to expect beforehand: the unit of velocity was zero once.
TEST_F(CoupledInertia, a_sphere_is_thrown_into_fluid_at_rest) {
  const auto thrown =
      run({"-o", "out", R"(gravity=["0 m/s^2","0 m/s^2","0 m/s^2"])", "run.end_time=1 ms"});
  ASSERT_EQ(thrown.exit_code, 0) << thrown.output;
  const Impact found = impact("out");
  EXPECT_NEAR(found.down, 0.2, 1e-6);
  EXPECT_EQ(found.up, 0);
}

TEST_F(CoupledInertia, says_what_it_cannot_do) {
  const auto refused = [&](const std::string& change) {
    const auto result = run({"-o", "out", change});
    EXPECT_EQ(result.exit_code, 2) << result.output;
    return result.output;
  };
  EXPECT_NE(refused("flow.time_scheme=midpoint").find("bdf2"), std::string::npos);
  EXPECT_NE(refused("flow.steady=true").find("end_time"), std::string::npos);
}

}  // namespace
}  // namespace porefines::test
