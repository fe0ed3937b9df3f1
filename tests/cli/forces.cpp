// SPDX-License-Identifier: MPL-2.0
// porefines forces as a user runs it.
#include <gtest/gtest.h>

#include "cli/run_support.hpp"
#include "core/atomic_file.hpp"

namespace porefines::test {
namespace {

const std::string shipped = PF_SOURCE_DIR "/cases/dlvo/forces.toml";

ProgramResult forces(const Scratch& folder, std::vector<std::string> words) {
  words.insert(words.begin(), {PF_BINARY, "forces"});
  return run_on(1, folder, words);
}

/// references.md D
TEST(Forces, writes_numbers_tables_and_charts_of_the_shipped_case) {
  const Scratch folder;
  const auto result = forces(folder, {shipped, "-o", "out"});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const std::string json = read_text(folder / "out/summary.json");
  EXPECT_NEAR(number(json, "debye_length_m"), 3.0401e-9, 0.5e-13);
  EXPECT_NEAR(number(json, "diffusivity_m2_s"), 9.8116e-14, 0.5e-18);
  EXPECT_NEAR(number(json, "wall_barrier_kT"), 2475.4, 0.1);
  EXPECT_NEAR(number(json, "wall_secondary_minimum_kT"), -7.316, 0.5e-3);
  EXPECT_NEAR(number(json, "jkr_pull_off_N"), 5.8905e-7, 0.5e-11);
  EXPECT_NEAR(number(json, "wall_primary_minimum_gap_m"), 0.28e-9, 0.01e-9);
  EXPECT_NEAR(number(json, "lever_m"), std::sqrt(2 * 5e-9 * 2.5e-6), 1e-12);
  EXPECT_NEAR(number(json, "critical_shear_stress_adhesion_Pa") / 135.73, 1, 1e-3);
  for (const char* name : {"wall.png", "wall_minimum.png", "particles.png"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / (std::string("out/") + name))) << name;
  }
}

TEST(Forces, the_table_adds_up_and_its_force_is_the_slope) {
  const Scratch folder;
  ASSERT_EQ(forces(folder, {shipped, "-o", "out"}).exit_code, 0);
  const Csv table = read_csv(folder / "out/particles.csv");
  ASSERT_GT(table.rows.size(), 300);
  const double kt = number(read_text(folder / "out/summary.json"), "kT_J");
  for (std::size_t i = 100; i + 1 < table.rows.size(); i += 50) {
    const double energy = table.at(i, "energy_kT");
    EXPECT_NEAR(
        table.at(i, "van_der_waals_kT") + table.at(i, "double_layer_kT") + table.at(i, "born_kT"),
        energy, 1e-6 * std::abs(table.at(i, "van_der_waals_kT")));
    const double step = table.at(i + 1, "gap_m") - table.at(i - 1, "gap_m");
    const double slope = (table.at(i - 1, "energy_kT") - table.at(i + 1, "energy_kT")) * kt / step;
    EXPECT_NEAR(table.at(i, "force_N"), slope, 0.01 * std::abs(slope) + 1e-15) << i;
  }
}

/// references.md D: 1 um in water at 15 degrees.
TEST(Forces, takes_values_from_the_command_line) {
  const Scratch folder;
  const auto result = forces(folder, {shipped, "-o", "out", "particles.diameter=1 um",
                                      "colloid.temperature=288.15 K", "fluid.viscosity=1 mPa s"});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const std::string json = read_text(folder / "out/summary.json");
  EXPECT_NEAR(number(json, "collector_efficiency"), 0.0190009, 0.5e-7);
  EXPECT_NEAR(number(json, "collector_efficiency_gravity"), 1.8303e-3, 0.5e-7);
  EXPECT_NEAR(number(json, "collector_efficiency_rajagopalan_tien"), 0.027092, 0.5e-6);
}

/// Opposite charges, nothing asked beyond the curves.
TEST(Forces, favourable_surfaces) {
  const Scratch folder;
  write_file(folder / "f.toml",
             "[colloid]\nhamaker = \"1e-20 J\"\nzeta_particle = \"-80 mV\"\nzeta_wall = \"30 mV\"\n"
             "ionic_strength = \"1 mM\"\n[particles]\ndiameter = \"50 nm\"\n");
  const auto result = forces(folder, {"f.toml"});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  EXPECT_NE(result.output.find("barrier            none"), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("note: a zeta potential of 80 mV"), std::string::npos);
  EXPECT_NE(result.output.find("Derjaguin's approximation wants 5"), std::string::npos);
  const std::string json = read_text(folder / "out/forces/summary.json");
  EXPECT_NE(json.find("\"wall_barrier_kT\": null"), std::string::npos);
  EXPECT_EQ(json.find("jkr"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder / "out/forces/wall.png"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out/forces/wall_minimum.png"));
}

TEST(Forces, wrong_input_writes_nothing) {
  const Scratch folder;
  const auto refused = [&](const std::vector<std::string>& words, const std::string& message) {
    const auto result = forces(folder, words);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.output, message);
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  };
  refused({"none.toml"},
          "porefines: none.toml: cannot be read; the first argument is a file in TOML as "
          "docs/forces.md explains it\n");
  refused({shipped, "colloid.zeta_wall=30 V"},
          "porefines: command line: colloid.zeta_wall: \"30 V\" is out of range, allowed is from "
          "-1 V to 1 V\nfor example \"-35 mV\"\n");
  refused({},
          "porefines: FILE.toml is required\nporefines --help, or porefines run --help, shows "
          "what there is\n");
}

}  // namespace
}  // namespace porefines::test
