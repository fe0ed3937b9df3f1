// SPDX-License-Identifier: MPL-2.0
// From a case to its permeability at the shell, against exact values.
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "cli/run_support.hpp"
#include "core/atomic_file.hpp"
#include "core/types.hpp"

namespace porefines {
namespace {

using test::number;

class Permeability : public ::testing::Test {
 protected:
  Permeability() {
    write_file(folder_ / "chip.toml", test::chip_case);
    write_file(folder_ / "sphere.toml", test::sphere_case);
    write_file(folder_ / "one.txt", test::sphere_list);
  }

  /// Runs and returns summary.json.
  std::string summary_of(std::vector<std::string> words) {
    words.insert(words.begin(), {"run"});
    const auto result = test::porefines_in(folder_.path(), words);
    EXPECT_EQ(result.exit_code, 0) << result.output;
    return test::read_text(folder_ / "out/summary.json");
  }

  test::Scratch folder_;
};

/// Weighted half-cell walls give h^2/12 (1 + 1/(2 n^2) + 3/(16 n^3)) with n cells over the depth.
TEST_F(Permeability, of_an_empty_chip_is_that_of_two_plates) {
  constexpr Real depth = 16e-6;
  const std::string coarse = summary_of({"chip.toml"});
  EXPECT_NEAR(number(coarse, "permeability_m2") / (depth * depth / 12), 1 + 1.0 / 512 + 3.0 / 65536,
              1e-5);
  EXPECT_LT(number(coarse, "flux_variation"), 1e-6);
  const std::string fine = summary_of({"chip.toml", "grid.cells=[32, 16, 32]"});
  EXPECT_NEAR(number(fine, "permeability_m2") / (depth * depth / 12), 1, 0.0006);
}

/// k must not depend on how the flow is driven, nor on the pressure level.
TEST_F(Permeability, is_the_same_for_a_syringe_pump) {
  const Real by_pressure = number(summary_of({"chip.toml"}), "permeability_m2");
  write_file(folder_ / "pump.toml",
             "[geometry]\nkind = \"empty\"\nsize = [\"32 um\", \"16 um\", \"16 um\"]\n"
             "[grid]\ncells = [32, 16, 16]\n[flow]\n"
             "inlet = { face = \"x-\", flow_rate = \"1 uL/min\" }\n"
             "outlet = { face = \"x+\", pressure = \"1 atm\" }\n"
             "walls = [\"z-\", \"z+\"]\nslip = [\"y-\", \"y+\"]\n");
  const std::string pumped = summary_of({"pump.toml"});
  EXPECT_NEAR(number(pumped, "permeability_m2") / by_pressure, 1, 1e-5);
  EXPECT_NEAR(number(pumped, "flow_rate_m3_s") / (1e-9 / 60), 1, 1e-9);
  const Real drop =
      1.002e-3 * number(pumped, "flow_rate_m3_s") / (16e-6 * 16e-6) * 32e-6 / by_pressure;
  EXPECT_NEAR(number(pumped, "pressure_drop_pa") / drop, 1, 1e-5) << "the pressure the pump needs";
}

TEST_F(Permeability, does_not_count_reservoirs) {
  const Real plain = number(summary_of({"chip.toml"}), "permeability_m2");
  const std::string with = summary_of({"chip.toml", "flow.reservoir=8 um"});
  EXPECT_NEAR(number(with, "permeability_m2") / plain, 1, 1e-5);
  EXPECT_EQ(number(with, "cells"), (32 + 16) * 16 * 16);
  EXPECT_NEAR(number(with, "pressure_drop_pa"), 12.0 * 32 / 48, 1e-4);
}

/// Zick & Homsy (1982): K = 7.441953 at a solid fraction of 0.216.
TEST_F(Permeability, of_a_sphere_array_and_its_drag) {
  const std::string summary = summary_of({"sphere.toml", "flow.tensor=true"});
  EXPECT_NEAR(number(summary, "drag_coefficient_mean") / 7.441953, 1, 0.012);
  EXPECT_NEAR(number(summary, "drag_n"), 1e-9, 1e-15);
  EXPECT_NEAR(number(summary, "porosity"), 0.784, 0.003);
  const Real k = number(summary, "permeability_m2");
  EXPECT_EQ(number(summary, "k_xx"), k);
  EXPECT_NEAR(number(summary, "k_zz") / k, 1, 1e-4) << "the array is isotropic";
  EXPECT_NEAR(number(summary, "k_xy") / k, 0, 1e-4);
}

TEST_F(Permeability, two_ranks_find_what_one_finds) {
  const std::string one = summary_of({"sphere.toml", "flow.tolerance=1e-8"});
  const auto result = test::run_in(folder_.path(), {"mpirun", "-n", "2", PF_BINARY, "run",
                                                    "sphere.toml", "flow.tolerance=1e-8"});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const std::string two = test::read_text(folder_ / "out/summary.json");
  EXPECT_EQ(number(two, "ranks"), 2);
  for (const std::string key : {"permeability_m2", "porosity", "drag_n", "fluid_cells"}) {
    EXPECT_NEAR(number(two, key) / number(one, key), 1, 1e-6) << key;
  }
}

TEST_F(Permeability, leaves_everything_that_was_promised) {
  const std::string summary = summary_of({"chip.toml"});
  EXPECT_NE(summary.find("\"status\": \"done\""), std::string::npos) << summary;
  for (const std::string key :
       {"porosity", "porosity_connected", "permeability_m2", "permeability_darcy",
        "darcy_velocity_m_s", "pressure_drop_pa", "flow_rate_m3_s", "flux_variation",
        "solver_cycles", "solver_residual", "cells", "fluid_cells", "ranks", "wall_time_s",
        "peak_memory_bytes"}) {
    EXPECT_FALSE(std::isnan(number(summary, key))) << key << " is missing in\n" << summary;
  }
  for (const std::string file :
       {"case.toml", "log.txt", "fields.xdmf", "fields.h5", "speed.png", "pressure.png"}) {
    EXPECT_TRUE(std::filesystem::exists(folder_ / ("out/" + file))) << file;
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "out")) {
    EXPECT_NE(entry.path().extension(), ".part") << entry.path() << " is half written";
  }
  const std::string again = summary_of({"out/case.toml"});
  EXPECT_EQ(number(again, "permeability_m2"), number(summary, "permeability_m2"))
      << "the effective case is not the same case";
}

TEST_F(Permeability, dry_run_says_what_to_expect_and_solves_nothing) {
  const auto result = test::porefines_in(folder_.path(), {"run", "sphere.toml", "--dry-run"});
  EXPECT_EQ(result.exit_code, 0) << result.output;
  for (const std::string word :
       {"16 x 16 x 16", "mean diameter", "Re ", "memory", "geometry.png"}) {
    EXPECT_NE(result.output.find(word), std::string::npos) << word << " is missing in\n"
                                                           << result.output;
  }
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/geometry.png"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/summary.json"));
}

TEST_F(Permeability, memory_is_foreseen) {
  const std::string summary = summary_of({"chip.toml", "grid.cells=[96, 64, 64]"});
  EXPECT_NEAR(number(summary, "planned_memory_bytes") / number(summary, "peak_memory_bytes"), 1,
              0.15);
}

/// What stopped itself says so, and shows no number that could be mistaken for a result.
TEST_F(Permeability, stops_with_advice_when_the_solve_does_not_converge) {
  (void)summary_of({"sphere.toml"});
  const auto result =
      test::porefines_in(folder_.path(), {"run", "sphere.toml", "flow.max_cycles=2"});
  EXPECT_EQ(result.exit_code, 3) << result.output;
  EXPECT_NE(result.output.find("did not converge: residual "), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("try a larger flow.max_cycles"), std::string::npos);
  const std::string summary = test::read_text(folder_ / "out/summary.json");
  EXPECT_NE(summary.find("\"status\": \"stopped\""), std::string::npos) << summary;
  EXPECT_EQ(summary.find("permeability"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/speed.png")) << "of the run before";
}

}  // namespace
}  // namespace porefines
