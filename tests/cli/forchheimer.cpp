// SPDX-License-Identifier: MPL-2.0
// porefines fit on the folder of a study.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cli/run_support.hpp"
#include "core/atomic_file.hpp"

namespace porefines::test {
namespace {

/// What a study of water through k = 1e-10 m^2, beta = 2e4 1/m leaves behind, and a member that failed.
void leave_study(const Scratch& folder, const std::string& regime) {
  std::string members = "member,group,folder,status\n";
  int number = 0;
  for (const double u : {1e-6, 2e-6, 4e-6, 0.2, 0.4, 0.8}) {
    const std::string name = fmt::format("m{}", ++number);
    members += fmt::format("{0},{0},{1},done\n", number, name);
    std::filesystem::create_directories(folder / ("members/" + name));
    write_file(folder / ("members/" + name + "/summary.json"),
               fmt::format("{{\"status\": \"done\", \"regime\": \"{}\", \"darcy_velocity_m_s\": {},"
                           " \"pressure_drop_pa\": {}, \"length_m\": 0.01, "
                           "\"fluid_density_kg_m3\": 1000, \"fluid_viscosity_pa_s\": 0.001}}\n",
                           regime, u, 0.01 * (1e-3 * u / 1e-10 + 2e4 * 1000 * u * u)));
  }
  write_file(folder / "members.csv", members + "7,7,m7,failed\n");
  write_file(folder / "study.json", "{}\n");
}

TEST(ForchheimerFit, reads_a_study_and_writes_table_numbers_and_chart) {
  const Scratch folder;
  leave_study(folder, "navier-stokes");
  const auto result = run_on(1, folder, {PF_BINARY, "fit", "."});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const std::string json = read_text(folder / "forchheimer.json");
  EXPECT_NEAR(number(json, "beta_per_m") / 2e4, 1, 1e-5);
  EXPECT_NEAR(number(json, "permeability_m2") / 1e-10, 1, 1e-5);
  EXPECT_EQ(read_csv(folder / "forchheimer.csv").rows.size(), 6);
  EXPECT_TRUE(std::filesystem::exists(folder / "forchheimer.png"));
}

TEST(ForchheimerFit, wants_flows_with_inertia) {
  const Scratch folder;
  leave_study(folder, "stokes");
  const auto result = run_on(1, folder, {PF_BINARY, "fit", "."});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.output.find("navier-stokes"), std::string::npos) << result.output;
}

}  // namespace
}  // namespace porefines::test
