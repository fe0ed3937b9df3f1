// SPDX-License-Identifier: MPL-2.0
// The engines run what was exported, where they are installed: make cross-check
// installs them.
#include "support/export_cases.hpp"

namespace porefines {
namespace {

using Engines = test::Export;

TEST_F(Engines, openfoam_finds_the_same_permeability) {
  if (!installed("simpleFoam") || !installed("snappyHexMesh")) {
    GTEST_SKIP() << "OpenFOAM is not installed: apt-get install openfoam";
  }
  ASSERT_EQ(porefines({"run", "pillar.toml", "output=[]"}).exit_code, 0);
  ASSERT_EQ(porefines({"export", "pillar.toml", "--to", "openfoam", "foam"}).exit_code, 0);
  const auto foam =
      test::run_in(folder_.path(), {"env", "WM_PROJECT_DIR=/usr/share/openfoam", "foam/Allrun"});
  ASSERT_EQ(foam.exit_code, 0) << foam.output
                               << test::read_text(folder_ / "foam/snappyHexMesh.log");
  const double theirs = std::stod(foam.output.substr(foam.output.find("permeability_m2") + 16));
  const double ours =
      test::number(test::read_text(folder_ / "out/summary.json"), "permeability_m2");
  EXPECT_NEAR(theirs, ours, 0.03 * ours);
}

TEST_F(Engines, liggghts_lays_the_same_spheres_on_the_floor) {
  if (!installed("liggghts")) {
    GTEST_SKIP() << "LIGGGHTS is not installed: apt-get install liggghts";
  }
  ASSERT_EQ(porefines({"export", "drop.toml", "--to", "liggghts", "dem"}).exit_code, 0);
  const auto dem = test::run_in(folder_ / "dem", {"liggghts", "-in", "in.porefines"});
  ASSERT_EQ(dem.exit_code, 0) << dem.output;
  const std::regex row("\n\\s*\\d+\\s+4\\s+(\\S+)\\s+(\\S+)\\s*\nLoop time");
  std::smatch last;
  ASSERT_TRUE(std::regex_search(dem.output, last, row)) << dem.output;
  EXPECT_NEAR(std::stod(last[2]), 1.4375e-4, 0.005 * 1.4375e-4);  // mean radius
  ASSERT_EQ(porefines({"run", "drop.toml"}).exit_code, 0);
  const test::Csv tracks = test::read_csv(folder_ / "out/tracks.csv");
  double ours = 0;
  for (std::size_t i = tracks.rows.size() - 4; i < tracks.rows.size(); ++i) {
    ours += tracks.at(i, "z_m") / 4;
  }
  EXPECT_NEAR(std::stod(last[2]), ours, 0.005 * ours);
}

}  // namespace
}  // namespace porefines
