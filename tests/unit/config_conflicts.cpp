// SPDX-License-Identifier: MPL-2.0
// Keys that are right alone and wrong together, with the exact message that the user sees.
#include <gtest/gtest.h>

#include "config/reader.hpp"
#include "core/error.hpp"
#include "unit/config_cases.hpp"

namespace porefines::config {
namespace {

struct Conflict {
  const char* geometry;
  const char* grid;
  const char* flow;
  const char* message;
};

constexpr auto box = "kind = \"empty\"\nsize = [\"1 mm\", \"1 mm\", \"1 mm\"]";  // lines 2, 3
constexpr auto cells = "cell_size = \"50 um\"";                                  // line 5
constexpr auto drive = "periodic = [\"x\"]\npressure_gradient = \"1 Pa/m\"";     // lines 7, 8

class Conflicts : public ::testing::TestWithParam<Conflict> {};

TEST_P(Conflicts, are_explained) {
  const auto& [geometry, grid, flow, message] = GetParam();
  const std::string text =
      std::string("[geometry]\n") + geometry + "\n[grid]\n" + grid + "\n[flow]\n" + flow + "\n";
  try {
    (void)parse_case(text, "x.toml");
    FAIL() << "accepted:\n" << text;
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), message) << text;
  }
}

constexpr Conflict geometry_conflicts[] = {
    {"source = \"a.png\"", cells, drive,
     "x.toml:1: [geometry] pixel_size: is missing\n"
     "an image does not know its size: pixel_size = \"5.345 um\""},
    {"pixel_size = \"1 um\"", cells, drive,
     "x.toml:1: [geometry] source: is missing\nname the image, e.g. source = \"rock.tif\""},
    {"kind = \"spheres\"\nsize = [\"1 mm\", \"1 mm\", \"1 mm\"]", cells, drive,
     "x.toml:1: [geometry] source: is missing\n"
     "name the list of grains, e.g. source = \"grains.txt\""},
    {"kind = \"cylinders\"\nsource = \"a.txt\"", cells, drive,
     "x.toml:1: [geometry] size: is missing\nthe box: size = [\"1 mm\", \"1 mm\", \"1 mm\"]"},
    {"kind = \"empty\"\npixel_size = \"1 um\"", cells, drive,
     "x.toml:3: [geometry] pixel_size: has no meaning for geometry.kind = \"empty\"\n"
     "delete the key, or change the kind"},
    {"threshold = 100\npore_value = 0", cells, drive,
     "x.toml:3: [geometry] pore_value: has no meaning beside threshold\n"
     "a binary image has a pore_value, a grey one a threshold: delete one of them"},
    {"pore_is_bright = false", cells, drive,
     "x.toml:2: [geometry] pore_is_bright: has no meaning without threshold\n"
     "for a binary image say which value is pore: pore_value = 0"},
    {"crop = [[5, 5], [0, 9]]", cells, drive,
     "x.toml:2: [geometry] crop: [5, 5] is empty: first must be less than past-last"},
    {"crop = [[0, 9], [0, 9], [0, 0]]", cells, drive,
     "x.toml:2: [geometry] crop: [0, 0] is empty: first must be less than past-last"},
    {"crop = [[5, 9]]", cells, drive,
     "x.toml:2: [geometry] crop: has 1 pairs, needs one per axis: [[0, 400], [0, 300]], and a "
     "third pair for a volume"},
    {box, "decomposition = \"auto\"", drive,
     "x.toml:4: [grid] cell_size: is missing\n"
     "give cell_size = \"5 um\", or cells = [64, 64, 64]"},
    {"source = \"a.png\"\npixel_size = \"2 um\"", "decomposition = \"auto\"", drive,
     "x.toml:4: [grid] cell_size: is missing\n"
     "a good start is one cell per pixel: cell_size = \"2e-06 m\""},
    {box, "cell_size = \"50 um\"\ncells = [20, 20, 20]", drive,
     "x.toml:6: [grid] cells: is given beside cell_size\ndelete one of the two"},
    {"source = \"a.raw\"\npixel_size = \"2 um\"\nraw_size = [200, 100, 100]",
     "cell_size = \"300 um\"", drive,
     "x.toml:6: [grid] cell_size: 0.0003 m is larger than the box, 0.0002 m along y\n"
     "is the unit right?"},
};
INSTANTIATE_TEST_SUITE_P(Geometry, Conflicts, ::testing::ValuesIn(geometry_conflicts));

constexpr Conflict flow_conflicts[] = {
    {box, cells, "periodic = [\"x\"]",
     "x.toml:6: [flow] pressure_gradient: nothing drives the flow\n"
     "give inlet and outlet, or a pressure_gradient along a periodic axis"},
    {box, cells, "",
     "x.toml:6: [flow] inlet: nothing drives the flow\n"
     "give inlet and outlet, or a pressure_gradient along a periodic axis"},
    {box, cells, "periodic = [\"x\"]\npressure_gradient = \"0 Pa/m\"",
     "x.toml:8: [flow] pressure_gradient: nothing drives the flow\n"
     "give inlet and outlet, or a pressure_gradient along a periodic axis"},
    {box, cells, "pressure_gradient = \"1 Pa/m\"",
     "x.toml:7: [flow] pressure_gradient: acts along x, which is not periodic\n"
     "add periodic = [\"x\"], or use inlet and outlet instead"},
    {box, cells, "periodic = [\"x\"]\npressure_gradient = [\"1 Pa/m\", \"1 Pa/m\", \"0 Pa/m\"]",
     "x.toml:8: [flow] pressure_gradient: acts along y, which is not periodic\n"
     "add periodic = [\"y\"], or use inlet and outlet instead"},
    {box, cells, "periodic = [\"x\"]\npressure_gradient = [\"1 Pa/m\"]",
     "x.toml:8: [flow] pressure_gradient: has 1 components, needs 3: "
     "[\"1 Pa/m\", \"0 Pa/m\", \"0 Pa/m\"]"},
    {box, cells, "inlet = { face = \"x-\", pressure = \"1 Pa\" }",
     "x.toml:7: [flow] inlet: there is no outlet\nwhat enters must leave: give both"},
    {box, cells,
     "inlet = { face = \"x-\", pressure = \"1 Pa\" }\noutlet = { face = \"x-\", pressure = \"0\" }",
     "x.toml:8: [flow] outlet.face: is also the face of the inlet\n"
     "they are usually opposite: \"x-\" and \"x+\""},
    {box, cells,
     "inlet = { face = \"x-\", pressure = \"1 Pa\", flow_rate = \"1 uL/min\" }\n"
     "outlet = { face = \"x+\", pressure = \"0 Pa\" }",
     "x.toml:7: [flow] inlet.flow_rate: is given beside pressure\n"
     "one of them follows from the other: delete one"},
    {box, cells, "inlet = { face = \"x-\" }\noutlet = { face = \"x+\", pressure = \"0 Pa\" }",
     "x.toml:7: [flow] inlet: needs a pressure, a flow_rate or a velocity\n"
     "inlet = { face = \"x-\", pressure = \"12 Pa\" }"},
    {box, cells, "inlet = { face = \"x-\", pressure = \"1 Pa\" }\noutlet = { pressure = \"0 Pa\" }",
     "x.toml:8: [flow] outlet: needs a face\noutlet = { face = \"x+\", pressure = \"0 Pa\" }"},
    {box, cells,
     "inlet = { face = \"x-\", velocity = \"1 mm/s\" }\n"
     "outlet = { face = \"x+\", flow_rate = \"1 uL/min\" }",
     "x.toml:8: [flow] outlet: needs a pressure, since the inlet has a flow rate or a velocity\n"
     "outlet = { face = \"x+\", pressure = \"0 Pa\" }"},
    {box, cells,
     "inlet = { face = \"x-\", pressure = \"1 Pa\" }\noutlet = { face = \"x+\", pressure = \"1 "
     "Pa\" }",
     "x.toml:7: [flow] inlet: nothing drives the flow: inlet and outlet have the same pressure"},
    {box, cells,
     "inlet = { face = \"x-\", velocity = \"0 m/s\" }\n"
     "outlet = { face = \"x+\", pressure = \"1 Pa\" }",
     "x.toml:7: [flow] inlet: nothing drives the flow: its rate is zero"},
    {box, cells,
     "periodic = [\"x\"]\ninlet = { face = \"x-\", pressure = \"1 Pa\" }\n"
     "outlet = { face = \"y+\", pressure = \"0 Pa\" }",
     "x.toml:8: [flow] inlet.face: face x- belongs to the periodic axis x\n"
     "take \"x\" out of periodic, or x- out of inlet.face"},
    {box, cells, "periodic = [\"x\"]\npressure_gradient = \"1 Pa/m\"\nwalls = [\"x+\"]",
     "x.toml:9: [flow] walls: face x+ belongs to the periodic axis x\n"
     "take \"x\" out of periodic, or x+ out of walls"},
    {box, cells,
     "periodic = [\"x\"]\npressure_gradient = \"1 Pa/m\"\nwalls = [\"z-\"]\nslip = [\"z-\"]",
     "x.toml:10: [flow] slip: face z- is already in walls\na face is one thing only"},
    {box, cells,
     "periodic = [\"x\"]\npressure_gradient = \"1 Pa/m\"\nwalls = [\"z-\"]\n"
     "sides = { faces = [\"z-\"], kind = \"slip\" }",
     "x.toml:10: [flow] sides: face z- is already in walls\na face is one thing only"},
    {box, cells,
     "inlet = { face = \"x-\", pressure = \"1 Pa\" }\n"
     "outlet = { face = \"x+\", pressure = \"0 Pa\" }\nslip = [\"x+\"]",
     "x.toml:9: [flow] slip: face x+ is already in outlet.face\na face is one thing only"},
    {box, cells,
     "inlet = { face = \"x-\", pressure = \"1 Pa\" }\n"
     "outlet = { face = \"x+\", pressure = \"0 Pa\" }\n"
     "periodic = [\"y\"]\npressure_gradient = \"1 Pa/m\"",
     "x.toml:10: [flow] pressure_gradient: is given beside inlet and outlet\n"
     "the flow is driven by one or the other: delete one"},
    {box, cells,
     "inlet = { face = \"x-\", pressure = \"1 Pa\" }\n"
     "outlet = { face = \"x+\", pressure = \"0 Pa\" }\ntensor = true",
     "x.toml:9: [flow] tensor: needs periodic axes, not inlet and outlet\n"
     "the tensor comes from driving each periodic axis in turn"},
    {box, cells, "tensor = true",
     "x.toml:7: [flow] tensor: needs at least one periodic axis\nperiodic = [\"x\", \"y\", \"z\"]"},
    {box, cells, "periodic = [\"x\"]\npressure_gradient = \"1 Pa/m\"\nreservoir = \"10 um\"",
     "x.toml:9: [flow] reservoir: has no meaning without inlet and outlet"},
    {box, cells,
     "periodic = [\"x\"]\npressure_gradient = \"1 Pa/m\"\npressure_tolerance = 1e-6\n"
     "tolerance = 1e-6",
     "x.toml:10: [flow] tolerance: is given beside pressure_tolerance\n"
     "they mean the same: delete one"},
    {box, cells, "periodic = [\"x\"]\npressure_gradient = \"1 Pa/m\"\nsides = { kind = \"slip\" }",
     "x.toml:9: [flow] sides: needs both faces and kind\n"
     "{ faces = [\"y-\", \"y+\"], kind = \"slip\" }"},
};
INSTANTIATE_TEST_SUITE_P(Flow, Conflicts, ::testing::ValuesIn(flow_conflicts));

}  // namespace
}  // namespace porefines::config
