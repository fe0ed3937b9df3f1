// SPDX-License-Identifier: MPL-2.0
#include <filesystem>

#include "cli/run_support.hpp"
#include "core/atomic_file.hpp"

namespace porefines {
namespace {

TEST(Scale, tells_times_shares_and_a_number_to_take) {
  const test::Scratch folder;
  write_file(folder / "chip.toml", test::chip_case);
  const auto result = test::porefines_in(
      folder.path(),
      {"scale", "chip.toml", "output=[]", "--ranks", "1", "2", "--repeats", "1", "-o", "out"});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  EXPECT_NE(result.output.find("take"), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("not measured"), std::string::npos) << result.output;
  const test::Csv table = test::read_csv(folder / "out/scale.csv");
  ASSERT_EQ(table.rows.size(), 2);
  EXPECT_EQ(table.at(0, "messages_per_rank"), 0);
  EXPECT_GT(table.at(1, "messages_per_rank"), 10);
  EXPECT_GT(table.at(1, "bytes_per_rank"), table.at(1, "messages_per_rank"));
  EXPECT_GT(table.at(1, "collectives_per_rank"), 5);
  for (std::size_t row = 0; row < 2; ++row) {
    EXPECT_GE(table.at(row, "waiting_s"), 0);
    EXPECT_NEAR(table.at(row, "compute_s") + table.at(row, "halo_s") +
                    table.at(row, "reductions_s") + table.at(row, "waiting_s"),
                table.at(row, "seconds"), 1e-9);
  }
  EXPECT_TRUE(std::filesystem::exists(folder / "out/scale.png"));
  EXPECT_TRUE(std::filesystem::exists(folder / "out/scale.json"));
}

TEST(Scale, says_why_a_case_does_not_run) {
  const test::Scratch folder;
  write_file(folder / "chip.toml", test::chip_case);
  const auto result = test::porefines_in(folder.path(), {"scale", "chip.toml", "grid.cels=3"});
  EXPECT_EQ(result.exit_code, 2) << result.output;
  EXPECT_NE(result.output.find("did you mean cells"), std::string::npos) << result.output;
}

}  // namespace
}  // namespace porefines
