// SPDX-License-Identifier: MPL-2.0
// Particles that cannot be: exit code 2, a message that helps, nothing run.
#include <filesystem>

#include <gtest/gtest.h>

#include "cli/run_support.hpp"
#include "core/atomic_file.hpp"

namespace porefines {
namespace {

const std::string base = R"([run]
end_time = "1 ms"
[geometry]
kind = "empty"
size = ["1 mm", "1 mm", "1 mm"]
)";

class WrongParticles : public ::testing::Test {
 protected:
  void expect_refused(const std::string& text, const std::string& message) {
    write_file(folder_ / "case.toml", base + text);
    const auto result = test::porefines_in(folder_.path(), {"run", "case.toml"});
    EXPECT_EQ(result.exit_code, 2) << result.output;
    EXPECT_NE(result.output.find(message), std::string::npos) << result.output;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out")) << "something was run";
  }
  void write_list(const std::string& rows) {
    write_file(folder_ / "list.csv", "x_m,y_m,z_m,diameter_m\n" + rows);
  }

  test::Scratch folder_;
};

const std::string listed = "[[particles]]\nsource = \"list.csv\"\n";

TEST_F(WrongParticles, overlap_at_the_start) {
  write_list("2e-4,5e-4,5e-4,1e-4\n5e-4,5e-4,5e-4,1e-4\n5.5e-4,5e-4,5e-4,1e-4\n");
  expect_refused(listed,
                 "at the start particle 1 overlaps particle 2 by 5e-05 m, near (0.0005, "
                 "0.0005, 0.0005) m\nmove or shrink it");
}

TEST_F(WrongParticles, overlap_a_wall_at_the_start) {
  write_list("2e-4,5e-4,2e-5,1e-4\n");
  expect_refused(listed, "at the start particle 0 overlaps a wall by 3e-05 m");
}

TEST_F(WrongParticles, outside_the_box) {
  write_list("2e-4,5e-4,5e-3,1e-4\n");
  expect_refused(listed,
                 "[[particles]] particles: particle 0 at (0.0002, 0.0005, 0.005) m is outside "
                 "the box, 0 m to 0.001 m along z");
}

TEST_F(WrongParticles, of_no_size) {
  write_list("2e-4,5e-4,5e-4,0\n");
  expect_refused(listed, "list.csv:2: a diameter of 0 m; it must be positive");
  expect_refused("[[particles]]\ndiameter = \"-5 um\"\ncount = 1\n",
                 "case.toml:7: [[particles]] diameter: \"-5 um\" is out of range");
}

TEST_F(WrongParticles, of_no_stiffness_or_negative_friction) {
  expect_refused("[[particles]]\ndiameter = \"5 um\"\ncount = 1\nyoung = \"0 Pa\"\n",
                 "case.toml:9: [[particles]] young: \"0 Pa\" is out of range");
  expect_refused("[[particles]]\ndiameter = \"5 um\"\ncount = 1\n[contact]\nfriction = -0.3\n",
                 "case.toml:10: [contact] friction: -0.3 is out of range");
}

TEST_F(WrongParticles, more_than_fit) {
  expect_refused("[[particles]]\ndiameter = \"0.3 mm\"\ncount = 60\n", "could not be placed apart");
  expect_refused("[[particles]]\ndiameter = \"2 mm\"\ncount = 1\n", "do not fit into a region");
}

TEST_F(WrongParticles, enter_through_rock) {
  write_file(folder_ / "grains.txt", "5e-4 5e-4 0 1.2e-3\n");
  write_file(folder_ / "case.toml", R"([run]
end_time = "1 ms"
[geometry]
kind = "spheres"
source = "grains.txt"
size = ["1 mm", "1 mm", "4 mm"]
[[particles]]
diameter = "0.1 mm"
[injection]
face = "z-"
rate = "1 kHz"
velocity = "1 mm/s"
)");
  const auto result = test::porefines_in(folder_.path(), {"run", "case.toml"});
  EXPECT_EQ(result.exit_code, 2) << result.output;
  EXPECT_NE(result.output.find("every place in the window is inside rock or a wall"),
            std::string::npos)
      << result.output;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

TEST_F(WrongParticles, a_file_that_is_not_there) {
  expect_refused("[[particles]]\nsource = \"nowhere.csv\"\n",
                 "case.toml:7: [[particles]] source: there is no file");
}

}  // namespace
}  // namespace porefines
