// SPDX-License-Identifier: MPL-2.0
// docs/guide.md: its commands run as written, one block after the other.
#include <filesystem>
#include <sstream>

#include <gtest/gtest.h>

#include "cli/run_support.hpp"
#include "core/atomic_file.hpp"

namespace porefines {
namespace {

/// What stands between ```sh and ``` lines.
std::string commands_of(const std::string& page) {
  std::istringstream lines(page);
  std::string line;
  std::string out = "set -eu\n";
  bool inside = false;
  while (std::getline(lines, line)) {
    if (line.rfind("```", 0) == 0) {
      inside = line == "```sh";
    } else if (inside) {
      out += line + "\n";
    }
  }
  return out;
}

TEST(Guide, runs_as_written) {
  const test::Scratch folder;
  const std::string script =
      commands_of(test::read_text(std::string(PF_SOURCE_DIR) + "/docs/guide.md"));
  ASSERT_GT(std::count(script.begin(), script.end(), '\n'), 60);
  const std::string programs = std::filesystem::path(PF_BINARY).parent_path();
  write_file(folder / "guide.sh", "export PATH=" + programs + ":$PATH\n" + script);
  test::Background shell(folder.path(), {"/bin/bash", "guide.sh"});
  const test::ProgramResult result = shell.end();
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const std::string flow = test::read_text(folder / "out/flow/summary.json");
  EXPECT_NEAR(test::number(flow, "permeability_darcy"), 3.010, 0.002) << "the guide says so";
  for (const char* file : {"look/geometry.png", "out/fines/report.html", "out/fines/series.csv",
                           "out/video/annotated.avi", "out/compared/sigma.png"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
  }
  const std::string agreement = test::read_text(folder / "out/compared/agreement.json");
  EXPECT_GT(test::number(agreement, "agreement"), 0.95);
}

}  // namespace
}  // namespace porefines
