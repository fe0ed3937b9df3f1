// SPDX-License-Identifier: MPL-2.0
// porefines validate: runs, compares, keeps what is done, goes red.
#include <gtest/gtest.h>

#include "cli/run_support.hpp"
#include "core/atomic_file.hpp"

namespace porefines::test {
namespace {

/// The speed of the ball's last row becomes another one.
void spoil(const std::string& path) {
  std::string text = read_text(path);
  const std::size_t row = text.rfind('\n', text.size() - 2) + 1;
  std::size_t at = row;
  for (int comma = 0; comma < 7; ++comma) {
    at = text.find(',', at) + 1;
  }
  text.replace(at, text.find(',', at) - at, "0.5");
  write_file(path, text);
}

TEST(Validate, is_green_keeps_what_is_done_and_sees_a_wrong_number) {
  const Scratch folder;
  const std::vector<std::string> words{"validate", "--only", "incline", "impact", "-o", "v"};
  const ProgramResult first = porefines_in(folder.path(), words);
  ASSERT_EQ(first.exit_code, 0) << first.output;
  EXPECT_NE(first.output.find("all green"), std::string::npos) << first.output;
  EXPECT_NE(first.output.find("done  v/impact/e_0.2"), std::string::npos) << first.output;
  const std::string json = read_text(folder / "v/validation.json");
  EXPECT_EQ(number(json, "red"), 0);
  EXPECT_NEAR(number(json, "value"), 11.98292, 0.01);  // the first row: the ball that rolls
  EXPECT_NE(read_text(folder / "v/validation.html").find("A ball on an incline"),
            std::string::npos);
  if (json.find("-dirty\"") != std::string::npos || json.find("\"unknown\"") != std::string::npos) {
    GTEST_SKIP() << "results of a changed source tree are never kept: commit to test that they are";
  }
  spoil(folder / "v/impact/e_0.2/out/tracks.csv");
  const ProgramResult second = porefines_in(folder.path(), words);
  EXPECT_EQ(second.exit_code, 3) << second.output;
  EXPECT_NE(second.output.find("kept  v/impact/e_0.2"), std::string::npos) << second.output;
  EXPECT_NE(second.output.find("RED    impact, e = 0.2"), std::string::npos) << second.output;
  EXPECT_EQ(number(read_text(folder / "v/validation.json"), "red"), 1);
}

TEST(Validate, names_what_there_is) {
  const Scratch folder;
  const ProgramResult wrong = porefines_in(folder.path(), {"validate", "--only", "sphere"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.output.find("did you mean spheres?"), std::string::npos) << wrong.output;
  EXPECT_NE(wrong.output.find("channels, spheres, cylinders"), std::string::npos) << wrong.output;
}

}  // namespace
}  // namespace porefines::test
