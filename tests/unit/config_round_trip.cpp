// SPDX-License-Identifier: MPL-2.0
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "config/key.hpp"
#include "config/reader.hpp"
#include "config/writer.hpp"
#include "unit/config_cases.hpp"

namespace porefines::config {
namespace {

using Overrides = std::vector<std::string>;

struct Variant {
  const char* name;
  std::string text;
  Overrides overrides;
};

class RoundTrip : public ::testing::TestWithParam<Variant> {};

TEST_P(RoundTrip, effective_case_reads_back_the_same) {
  const Variant& variant = GetParam();
  const Case original = parse_case(variant.text, "some/where.toml", variant.overrides);
  const std::string written = effective_case(original);
  Case again = parse_case(written, "else/where.toml");
  EXPECT_EQ(again.path, "else/where.toml");
  again.path = original.path;
  EXPECT_EQ(again, original) << written;
  EXPECT_EQ(effective_case(again), written);
}

const std::string list_case = R"([geometry]
kind = "spheres"
source = "pack.txt"
size = ["0.1 mm", "0.3 mm", "0.7 mm"]
[grid]
cells = [10, 30, 70]
[flow]
periodic = ["x", "y", "z"]
pressure_gradient = ["0.1 Pa/m", "0.3 kPa/m", "0"]
)";

const Variant variants[] = {
    {"box", test::box_case, {}},
    {"image", test::image_case, {}},
    {"spheres", list_case, {"geometry.list_unit=1 um", "geometry.periodic_images=false"}},
    {"no_output", test::box_case, {"output=[]"}},
    {"otsu", test::image_case, {"geometry.threshold=otsu", "geometry.pore_is_bright=false"}},
    {"grey",
     test::image_case,
     {"geometry.threshold=97", "geometry.smooth=0.1 um", "geometry.minimum_throat=3 um"}},
    {"cropped",
     test::image_case,
     {"geometry.crop=[[3, 40], [0, 7], [1, 9]]", "geometry.raw_size=[50, 60, 70]",
      "geometry.pore_value=0", "geometry.simplify=0.3", "geometry.fill_pores_below=4"}},
    {"cropped_2d", test::image_case, {"geometry.crop=[[3, 40], [0, 7]]"}},
    {"pump",
     test::image_case,
     {"flow.inlet={face=\"y+\", velocity=\"0.1 mm/s\"}", "flow.outlet.face=y-",
      "flow.slip=[\"x-\", \"z+\"]", "flow.reservoir=7 um", "flow.tolerance=1e-9",
      "grid.decomposition=[1, 2, 3]", "fine.diameter=0.3 um", "run.random_seed=9223372036854775807",
      "title=a \"quoted\" \\ title with \xc2\xb5 and \x7f", "fluid.viscosity=0.7 mPa s"}},
};
INSTANTIATE_TEST_SUITE_P(Case, RoundTrip, ::testing::ValuesIn(variants),
                         [](const auto& variant) { return std::string(variant.param.name); });

TEST(ReferencePage, is_the_one_in_docs) {
  std::ifstream file(PF_SOURCE_DIR "/docs/case-reference.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  EXPECT_TRUE(page == reference_page())
      << "regenerate it: porefines reference > docs/case-reference.md";
}

TEST(ReferencePage, explains_every_key_and_its_absence) {
  for (const Key& key : all_keys()) {
    EXPECT_FALSE(key.doc.empty()) << key.path;
    if (key.read) {
      EXPECT_FALSE(key.type.empty()) << key.path;
      EXPECT_FALSE(key.write(Case{}).empty() && key.absent.empty())
          << key.path << " has no default and does not say what its absence means";
    }
  }
}

}  // namespace
}  // namespace porefines::config
