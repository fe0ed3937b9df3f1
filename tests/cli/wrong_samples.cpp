// SPDX-License-Identifier: MPL-2.0
// Cases whose text is right and whose sample is not: exit code 2, nothing written.
#include <filesystem>

#include <gtest/gtest.h>

#include "cli/run_support.hpp"
#include "core/atomic_file.hpp"
#include "geom/image_write.hpp"
#include "geom/voxels.hpp"

namespace porefines {
namespace {

class WrongSample : public ::testing::Test {
 protected:
  WrongSample() {
    geom::Voxels open = geom::make_voxels({16, 16, 1}, 1);
    open.at(8, 8, 0) = 0;
    geom::write_image(folder_ / "open.png", open.view());
    for (int j = 0; j < 16; ++j) {
      open.at(4, j, 0) = 0;
    }
    geom::write_image(folder_ / "closed.png", open.view());
    write_file(folder_ / "corrupt.png", "\x89PNG\r\n\x1a\n and then nothing of use");
    write_file(folder_ / "chip.toml", test::chip_case);
    write_case("case.toml", "open.png", "");
  }

  void write_case(const std::string& name, const std::string& image, const std::string& geometry) {
    write_file(folder_ / name, "[geometry]\nsource = \"" + image +
                                   "\"\npixel_size = \"2 um\"\ndepth = \"20 um\"\n" + geometry +
                                   "[grid]\ncell_size = \"2 um\"\n"
                                   "[flow]\ninlet = { face = \"x-\", pressure = \"1 Pa\" }\n"
                                   "outlet = { face = \"x+\", pressure = \"0 Pa\" }\n");
  }

  void expect_refused(std::vector<std::string> words, const std::vector<std::string>& says) {
    words.insert(words.begin(), "run");
    const auto result = test::porefines_in(folder_.path(), words);
    EXPECT_EQ(result.exit_code, 2) << result.output;
    for (const std::string& word : says) {
      EXPECT_NE(result.output.find(word), std::string::npos)
          << "wanted: " << word << "\ngot: " << result.output;
    }
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out")) << "something was written";
  }

  test::Scratch folder_;
};

TEST_F(WrongSample, missing_image) {
  write_case("bad.toml", "nowhere.png", "");
  expect_refused({"bad.toml"}, {"[geometry] source: there is no file", "nowhere.png"});
}

TEST_F(WrongSample, corrupt_image) {
  write_case("bad.toml", "corrupt.png", "");
  expect_refused({"bad.toml"}, {"corrupt.png"});
}

TEST_F(WrongSample, no_percolating_path) {
  write_case("bad.toml", "closed.png", "");
  expect_refused({"bad.toml"}, {"closed.png"});
}

TEST_F(WrongSample, a_picture_without_depth) {
  write_file(
      folder_ / "bad.toml",
      "[geometry]\nsource = \"open.png\"\npixel_size = \"2 um\"\n[grid]\ncell_size = \"2 um\"\n"
      "[flow]\nperiodic = [\"x\"]\npressure_gradient = \"1 Pa/m\"\n");
  expect_refused({"bad.toml"}, {"is a 2D image", "depth = \"20 um\""});
}

TEST_F(WrongSample, wrong_unit) {
  expect_refused({"case.toml", "grid.cell_size=2 Pa"}, {"grid.cell_size", "length", "pressure"});
}

TEST_F(WrongSample, cell_larger_than_the_sample) {
  expect_refused({"case.toml", "grid.cell_size=2 mm"},
                 {"[grid] cell_size: 0.002 m is larger than the box", "is the unit right?"});
}

TEST_F(WrongSample, cell_absurdly_small) {
  expect_refused({"case.toml", "grid.cell_size=2 pm"}, {"more than 2^20", "is the unit right?"});
}

TEST_F(WrongSample, too_large_for_memory) {
  expect_refused({"chip.toml", "grid.cells=[8192, 8192, 8192]"},
                 {"times what this machine has free", "this would fit: cells = ["});
  expect_refused({"case.toml", "grid.cell_size=1 nm"},
                 {"times what this machine has free", "this would fit: cell_size = \""});
}

TEST_F(WrongSample, voxels_that_are_not_cells) {
  write_case("bad.toml", "open.png", "surface = \"voxel\"\n");
  expect_refused({"bad.toml", "grid.cell_size=1 um"}, {"surface = \"voxel\" needs cells that are"});
}

TEST_F(WrongSample, openings_around_a_corner) {
  expect_refused({"case.toml", "flow.outlet.face=y+"}, {"not on opposite faces"});
}

TEST_F(WrongSample, nothing_to_restart_from) {
  expect_refused({"case.toml", "--restart"}, {"a steady run has no checkpoint"});
}

}  // namespace
}  // namespace porefines
