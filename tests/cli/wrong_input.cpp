// SPDX-License-Identifier: MPL-2.0
// What a user does wrong at the shell: exit code 2, one clear message, nothing run.
#include <filesystem>

#include <gtest/gtest.h>

#include "core/atomic_file.hpp"
#include "support/program.hpp"
#include "support/scratch.hpp"
#include "unit/config_cases.hpp"

namespace porefines {
namespace {

class WrongInput : public ::testing::Test {
 protected:
  WrongInput() { write_file(folder_ / "box.toml", test::box_case); }

  void expect_refused(const std::vector<std::string>& arguments, const std::string& message) {
    const auto result = test::porefines_in(folder_.path(), arguments);
    EXPECT_EQ(result.exit_code, 2) << result.output;
    EXPECT_EQ(result.output, message);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out")) << "something was run";
  }

  test::Scratch folder_;
};

TEST_F(WrongInput, unknown_command) {
  expect_refused({"rum", "box.toml"},
                 "porefines: unknown command rum; did you mean run?\n"
                 "porefines --help shows what there is\n");
}

TEST_F(WrongInput, no_command) {
  expect_refused({},
                 "porefines: A subcommand is required\n"
                 "porefines --help, or porefines run --help, shows what there is\n");
}

TEST_F(WrongInput, no_case) {
  expect_refused({"run"},
                 "porefines: CASE.toml is required\n"
                 "porefines --help, or porefines run --help, shows what there is\n");
}

TEST_F(WrongInput, unknown_option) {
  expect_refused({"run", "box.toml", "--dryrun"},
                 "porefines: The following argument was not expected: --dryrun\n"
                 "porefines --help, or porefines run --help, shows what there is\n");
}

TEST_F(WrongInput, no_such_file) {
  expect_refused(
      {"run", "boxx.toml"},
      "porefines: boxx.toml: cannot be read; the first argument is a case file in TOML\n");
}

TEST_F(WrongInput, no_such_picture) {
  expect_refused({"inspect", "rokc.png"}, "porefines: rokc.png: there is no such file or folder\n");
}

TEST_F(WrongInput, a_wrong_key_in_the_file) {
  write_file(folder_ / "bad.toml", "[grid]\ncell_sise = \"1 um\"\n");
  expect_refused({"run", "bad.toml"},
                 "porefines: bad.toml:2: [grid] cell_sise: unknown key; did you mean cell_size?\n");
}

TEST_F(WrongInput, a_wrong_key_on_the_command_line) {
  expect_refused(
      {"run", "box.toml", "flow.max_cycle=3"},
      "porefines: command line: flow.max_cycle: unknown key; did you mean max_cycles?\n");
}

TEST_F(WrongInput, a_missing_image) {
  write_file(folder_ / "image.toml", test::image_case);
  const auto result = test::porefines_in(folder_.path(), {"run", "image.toml"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(
      result.output.starts_with("porefines: image.toml:2: [geometry] source: there is no file "))
      << result.output;
}

TEST_F(WrongInput, is_reported_once_by_several_ranks) {
  const auto result = test::run_in(folder_.path(), {"mpirun", "--oversubscribe", "-n", "3",
                                                    PF_BINARY, "run", "box.toml", "x=1"});
  EXPECT_EQ(result.exit_code, 2);
  const std::string message = "porefines: command line: x: unknown key\n";
  const auto first = result.output.find(message);
  ASSERT_NE(first, std::string::npos) << result.output;
  EXPECT_EQ(result.output.find(message, first + 1), std::string::npos) << result.output;
}

TEST(Help, explains_with_examples) {
  const test::Scratch folder;
  const auto help = test::porefines_in(folder.path(), {"--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const std::string word : {"run", "inspect", "generate", "mpirun -n 4", "Exit codes"}) {
    EXPECT_NE(help.output.find(word), std::string::npos) << word << " is missing in\n"
                                                         << help.output;
  }
  EXPECT_EQ(help.output.find("reference"), std::string::npos) << "a hidden command shows";
  const auto version = test::porefines_in(folder.path(), {"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_EQ(version.output.substr(0, 10), "porefines ");
  const auto run = test::porefines_in(folder.path(), {"run", "--help"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.output.find("--dry-run"), std::string::npos);
}

TEST(Reference, prints_the_page) {
  const test::Scratch folder;
  const auto page = test::porefines_in(folder.path(), {"reference"});
  EXPECT_EQ(page.exit_code, 0);
  EXPECT_NE(page.output.find("| `cell_size` |"), std::string::npos);
}

}  // namespace
}  // namespace porefines
