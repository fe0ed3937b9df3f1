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

const std::string full_dry_case = test::dry_case + R"([[particles]]
name = "fines"
diameter = { mean = "30 um", standard_deviation = "7 um", distribution = "lognormal", by = "volume" }
[[particles]]
name = "grit"
diameter = { diameters = ["10 um", "30 um"], shares = [0.1, 0.9] }
filling = "dense"
region = { low = ["0 m", "0 m", "1 mm"], high = ["1 mm", "1 mm", "1.7 mm"] }
velocity = ["0.1 m/s", "0 m/s", "0.3 m/s"]
force = ["0 N", "1e-9 N", "0 N"]
[[particles]]
name = "held"
source = "held.csv"
fixed = true
[contact]
model = "linear"
restitution = 0.7
friction = { particle_wall = 0.1 }
rolling = { model = "spring-dashpot", friction = 0.07 }
stiffness = "0.3 kN/m"
wall_young = "1 GPa"
[[injection]]
species = "fines"
face = "z+"
mass_fraction = 0.004
velocity = "1 mm/s"
pulses = { period = "3 ms", duration = "0.7 ms" }
[[injection]]
species = "sand"
face = "z+"
rate = "300 Hz"
velocity = "0.1 m/s"
stop = "9 ms"
region = { low = ["0.1 mm", "0 m", "0 m"], high = ["0.9 mm", "1 mm", "2 mm"] }
[[surface]]
kind = "plane"
point = ["0 m", "0 m", "0.1 mm"]
normal = [0.3, 0, 1]
[[surface]]
kind = "cylinder"
radius = "0.4 mm"
inside = true
[[surface]]
kind = "mesh"
source = "hopper.stl"
unit = "1 mm"
[[output]]
kind = "tracks"
every = "0.1 ms"
forces = true
)";

const Variant variants[] = {
    {"box", test::box_case, {}},
    {"image", test::image_case, {}},
    {"spheres", list_case, {"geometry.list_unit=1 um", "geometry.periodic_images=false"}},
    {"inertial",
     test::box_case,
     {"flow.regime=navier-stokes", "flow.scheme=lust", "flow.time_scheme=midpoint",
      "flow.courant=0.7", "flow.time_step=0.3 ms", "run.end_time=3 s", "flow.disturbance=0.1",
      "probe=[{ name = \"rear\", position = [\"1 um\", \"2 um\", \"3 um\"] }]"}},
    {"inertial_steady",
     test::box_case,
     {"flow.regime=navier-stokes", "flow.steady=true",
      "flow.lid={face=\"y+\", velocity=[\"1 m/s\", \"0 m/s\", \"0.3 m/s\"]}"}},
    {"no_output", test::box_case, {"output=[]"}},
    {"dry", test::dry_case, {"box.periodic=[\"x\"]", "box.open=[\"z-\"]", "run.max_wall=1 h"}},
    {"dry_in_full", full_dry_case, {}},
    {"otsu", test::image_case, {"geometry.threshold=otsu", "geometry.pore_is_bright=false"}},
    {"grey",
     test::image_case,
     {"geometry.threshold=97", "geometry.smooth=0.1 um", "geometry.minimum_throat=3 um"}},
    {"cropped",
     test::image_case,
     {"geometry.crop=[[3, 40], [0, 7], [1, 9]]", "geometry.raw_size=[50, 60, 70]",
      "geometry.pore_value=0", "geometry.simplify=0.3", "geometry.fill_pores_below=4"}},
    {"edited",
     test::image_case,
     {"geometry.erode_grains=2 um", "geometry.edit_mask=mask.png", "geometry.reconnect_gap=3"}},
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
