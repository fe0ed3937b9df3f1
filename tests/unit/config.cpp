// SPDX-License-Identifier: MPL-2.0
#include <filesystem>

#include <gtest/gtest.h>

#include "config/reader.hpp"
#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "support/scratch.hpp"
#include "unit/config_cases.hpp"

namespace porefines::config {
namespace {

using test::box_case;
using test::image_case;

TEST(Config, reads_the_units_into_si) {
  const Case c = parse_case(R"(title = "a chip"
[run]
output_dir = "results"
random_seed = 20211
[geometry]
source = "chip.png"
pixel_size = "0.625 um"
depth = "20 um"
threshold = "otsu"
smooth = "1.0 um"
keep = "all"
surface = "voxel"
remove_grains_below = 30
crop = [[10, 400], [0, 300]]
[grid]
cell_size = "1.25 um"
decomposition = [2, 1, 1]
[fluid]
density = "1 g/cm^3"
viscosity = "1.002 mPa s"
[fine]
diameter = "5 um"
[flow]
regime = "stokes"
steady = true
inlet = { face = "x-", flow_rate = "1 uL/min" }
outlet = { face = "x+", pressure = "1 mbar" }
sides = { faces = ["y-", "y+"], kind = "slip" }
reservoir = "10 um"
tolerance = 1e-8
max_cycles = 50
[[output]]
kind = "fields"
)",
                            "cases/chip/case.toml");
  EXPECT_EQ(c.run.title, "a chip");
  EXPECT_EQ(c.run.output_dir, "results");
  EXPECT_EQ(c.run.random_seed, 20211U);
  EXPECT_EQ(c.geometry.kind, GeometryKind::image);
  EXPECT_EQ(c.geometry.source, std::filesystem::absolute("cases/chip/chip.png"));
  EXPECT_DOUBLE_EQ(c.geometry.pixel_size, 0.625e-6);
  EXPECT_DOUBLE_EQ(c.geometry.depth, 20e-6);
  EXPECT_TRUE(c.geometry.otsu);
  EXPECT_DOUBLE_EQ(c.geometry.smooth, 1e-6);
  EXPECT_EQ(c.geometry.keep, Keep::all);
  EXPECT_EQ(c.geometry.surface, Surface::voxel);
  EXPECT_EQ(c.geometry.remove_grains_below, 30);
  EXPECT_EQ(c.geometry.crop, (std::array<Int3, 2>{Int3{10, 0, 0}, Int3{400, 300, 0}}));
  EXPECT_DOUBLE_EQ(c.grid.cell_size, 1.25e-6);
  EXPECT_EQ(c.grid.decomposition, (Int3{2, 1, 1}));
  EXPECT_DOUBLE_EQ(c.fluid.density, 1000);
  EXPECT_DOUBLE_EQ(c.fluid.viscosity, 1.002e-3);
  EXPECT_DOUBLE_EQ(c.analysis.fine_diameter, 5e-6);
  ASSERT_TRUE(c.flow.inlet && c.flow.outlet);
  EXPECT_EQ(c.flow.inlet->kind, DriveKind::flow_rate);
  EXPECT_DOUBLE_EQ(c.flow.inlet->value, 1e-9 / 60);
  EXPECT_EQ(c.flow.outlet->face, BoxFace::x_high);
  EXPECT_DOUBLE_EQ(c.flow.outlet->value, 100);
  EXPECT_EQ(c.flow.slip, (std::array<bool, 6>{false, false, true, true, false, false}));
  EXPECT_EQ(c.flow.walls, (std::array<bool, 6>{false, false, false, false, true, true}));
  EXPECT_DOUBLE_EQ(c.flow.reservoir, 10e-6);
  EXPECT_DOUBLE_EQ(c.flow.tolerance, 1e-8);
  EXPECT_EQ(c.flow.max_cycles, 50);
  ASSERT_EQ(c.output.size(), 1U);
  EXPECT_EQ(c.output[0].kind, OutputKind::fields);
}

TEST(Config, fills_the_defaults) {
  const Case c = parse_case(box_case, "box.toml");
  EXPECT_DOUBLE_EQ(c.fluid.viscosity, 1.002e-3);
  EXPECT_TRUE(find_output(c, OutputKind::fields) && find_output(c, OutputKind::pictures));
  EXPECT_FALSE(c.grid.decomposition);
  EXPECT_LT(c.flow.reservoir, 0);
}

TEST(Config, one_gradient_acts_along_the_first_periodic_axis) {
  using Gradient = std::array<Real, 3>;
  const auto gradient = [](const std::string& periodic, const std::string& value) {
    return parse_case(box_case, "box.toml",
                      {"flow.periodic=" + periodic, "flow.pressure_gradient=" + value})
        .flow.pressure_gradient;
  };
  EXPECT_EQ(gradient(R"(["x", "y", "z"])", "2 Pa/m"), (Gradient{2, 0, 0}));
  EXPECT_EQ(gradient(R"(["y"])", "2 Pa/m"), (Gradient{0, 2, 0}));
  EXPECT_EQ(gradient(R"(["z"])", R"(["0", "0 Pa/m", "3 Pa/m"])"), (Gradient{0, 0, 3}));
}

TEST(Config, faces_named_nowhere_are_walls_unless_periodic) {
  EXPECT_EQ(parse_case(box_case, "box.toml").flow.walls,
            (std::array<bool, 6>{false, false, true, true, true, true}));
}

TEST(Config, a_tensor_needs_no_gradient) {
  const Case c = parse_case(box_case, "box.toml", {"flow.tensor=true", "flow.pressure_gradient=0"});
  EXPECT_TRUE(c.flow.tensor);
}

TEST(Config, the_command_line_replaces_and_adds) {
  const Case c = parse_case(
      image_case, "chip.toml",
      {"grid.cell_size=1 um", "fluid.density=1050 kg/m^3", "geometry.keep=all", "flow.max_cycles=7",
       "flow.inlet.pressure=3 Pa", "grid.cell_size=4 um", "output=[]", "title=\"5\""});
  EXPECT_DOUBLE_EQ(c.grid.cell_size, 4e-6);  // the last one counts
  EXPECT_DOUBLE_EQ(c.fluid.density, 1050);
  EXPECT_EQ(c.geometry.keep, Keep::all);
  EXPECT_EQ(c.flow.max_cycles, 7);
  EXPECT_DOUBLE_EQ(c.flow.inlet->value, 3);
  EXPECT_TRUE(c.output.empty());
  EXPECT_EQ(c.run.title, "5");
}

TEST(Config, an_alternative_on_the_command_line_replaces_the_one_in_the_file) {
  const Case c =
      parse_case(image_case, "chip.toml", {"grid.cells=[8, 6, 2]", "flow.inlet.flow_rate=1 mL/s"});
  EXPECT_EQ(c.grid.cell_size, 0);
  EXPECT_EQ(c.grid.cells, (Int3{8, 6, 2}));
  EXPECT_EQ(c.flow.inlet->kind, DriveKind::flow_rate);
  EXPECT_THROW(
      (void)parse_case(image_case, "chip.toml", {"grid.cells=[8, 6, 2]", "grid.cell_size=1 um"}),
      InputError);
}

TEST(Config, paths_start_at_the_case_file_or_on_the_command_line_at_the_shell) {
  namespace fs = std::filesystem;
  EXPECT_EQ(parse_case(image_case, "a/b.toml").geometry.source, fs::absolute("a/chip.png"));
  EXPECT_EQ(parse_case(image_case, "a/b.toml", {"geometry.source=x/y.png"}).geometry.source,
            fs::absolute("x/y.png"));
  EXPECT_EQ(parse_case(image_case, "a/b.toml", {"geometry.source=/x/y.png"}).geometry.source,
            "/x/y.png");
}

TEST(LoadCase, misses_files_early) {
  const test::Scratch folder;
  const std::string path = folder / "case.toml";
  write_file(path, image_case);
  const auto message = [&] {
    try {
      (void)load_case(path);
      return std::string("accepted");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(message(), path + ":2: [geometry] source: there is no file " + (folder / "chip.png") +
                           "\na relative path starts at the folder of the case file");
  write_file(folder / "chip.png", "x");
  EXPECT_EQ(message(), "accepted");
  EXPECT_THROW((void)load_case(folder / "other.toml"), InputError);
  EXPECT_THROW((void)load_case(folder.path()), InputError);
}

}  // namespace
}  // namespace porefines::config
