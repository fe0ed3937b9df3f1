// SPDX-License-Identifier: MPL-2.0
// Cases carried over to the thesis's engines.
#include "support/export_cases.hpp"

namespace porefines {
namespace {

using Export = test::Export;

TEST_F(Export, writes_a_whole_openfoam_case) {
  const auto result = porefines({"export", "pillar.toml", "--to", "openfoam", "foam"});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  for (const char* file :
       {"0/U", "0/p", "system/blockMeshDict", "system/snappyHexMeshDict", "system/fvSchemes",
        "system/fvSolution", "system/controlDict", "constant/transportProperties",
        "constant/triSurface/grains.stl", "Allrun"}) {
    EXPECT_TRUE(std::filesystem::exists(folder_ / ("foam/" + std::string(file)))) << file;
  }
  const std::string mesh = test::read_text(folder_ / "foam/system/blockMeshDict");
  EXPECT_NE(mesh.find("(56 32 12)"), std::string::npos) << mesh;  // reservoirs of four cells
  EXPECT_NE(test::read_text(folder_ / "foam/system/fvSchemes").find("LUST"), std::string::npos);
}

TEST_F(Export, says_what_cannot_be_carried_over) {
  write_file(folder_ / "one.txt", test::sphere_list);
  write_file(folder_ / "sphere.toml", test::sphere_case);
  const auto periodic = porefines({"export", "sphere.toml", "--to", "openfoam", "foam"});
  EXPECT_EQ(periodic.exit_code, 2) << periodic.output;
  EXPECT_NE(periodic.output.find("periodic drive"), std::string::npos) << periodic.output;
  const auto empty = porefines({"export", "pillar.toml", "--to", "liggghts", "dem"});
  EXPECT_EQ(empty.exit_code, 2) << empty.output;
  EXPECT_EQ(porefines({"export", "pillar.toml", "--to", "ansys", "x"}).exit_code, 2);
}

}  // namespace
}  // namespace porefines
