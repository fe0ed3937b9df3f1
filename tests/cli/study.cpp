// SPDX-License-Identifier: MPL-2.0
// porefines study and fit as a user runs them.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "cli/coupled_support.hpp"

namespace porefines {
namespace {

namespace fs = std::filesystem;

class StudyRun : public test::Coupled {
 protected:
  void write(const std::string& case_text, const std::string& study) const {
    write_file(folder_ / "case.toml", case_text);
    write_file(folder_ / "pillars.txt", "20 0 8\n20 24 8\n");
    write_file(folder_ / "study.toml", "case = \"case.toml\"\noutput_dir = \"out\"\n" + study);
  }
  [[nodiscard]] test::ProgramResult study(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"study", "study.toml"});
    return test::porefines_in(folder_.path(), more);
  }
  [[nodiscard]] std::string member(std::size_t row) const {
    return folder_ /
           ("out/members/" + test::read_csv(folder_ / "out/members.csv").rows.at(row).at(2));
  }
};

/// Two pressures at which a fine of 9 um is sieved by a throat of 8 um.
TEST_F(StudyRun, gives_one_table_statistics_and_charts) {
  place(9e-6);
  write(test::throat_case + "[clogging]\nhold_time = \"10 ms\"\n",
        "[[axis]]\nname = \"pressure drop\"\nkey = \"flow.inlet.pressure\"\n"
        "values = [\"10 Pa\", \"20 Pa\"]\n");
  const auto plan = study({"--dry-run"});
  EXPECT_EQ(plan.exit_code, 0) << plan.output;
  EXPECT_NE(plan.output.find("2 members"), std::string::npos) << plan.output;
  EXPECT_FALSE(fs::exists(folder_ / "out/members.csv"));
  const auto result = study();
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const test::Csv members = test::read_csv(folder_ / "out/members.csv");
  ASSERT_EQ(members.rows.size(), 2);
  for (std::size_t row = 0; row < 2; ++row) {
    EXPECT_EQ(members.at(row, "clogged_throats"), 1);
    EXPECT_LT(members.at(row, "permeability_ratio"), 0.2);
    EXPECT_GT(members.at(row, "clogging.time_s"), 0);
  }
  const test::Csv groups = test::read_csv(folder_ / "out/groups.csv");
  EXPECT_EQ(groups.at(0, "clog_share"), 1);
  EXPECT_NEAR(groups.at(0, "time_s_mean"), members.at(0, "clogging.time_s"), 1e-12);
  EXPECT_EQ(test::read_csv(folder_ / "out/survival.csv").rows.size(), 6);
  EXPECT_GT(test::read_csv(folder_ / "out/bands.csv").rows.size(), 200);
  for (const char* chart :
       {"clogging_probability", "survival_time", "k_volumes", "permeability_ratio"}) {
    EXPECT_TRUE(fs::exists(folder_ / ("out/" + std::string(chart) + ".png"))) << chart;
  }
  const auto last = fs::last_write_time(member(0) + "/summary.json");
  const auto again = study();
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_NE(again.output.find("2 members are done already"), std::string::npos) << again.output;
  EXPECT_EQ(fs::last_write_time(member(0) + "/summary.json"), last);
}

/// Waits until the first member has a checkpoint.
bool has_checkpoint(const std::string& folder) {
  for (int naps = 0; naps < 60000; ++naps) {
    if (fs::exists(folder)) {
      for (const auto& entry : fs::directory_iterator(folder)) {
        if (fs::exists(entry.path() / "checkpoint.h5")) {
          return true;
        }
      }
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return false;
}

TEST_F(StudyRun, killed_in_the_middle_goes_on_without_loss) {
  write(test::slit_case,
        "set = [\"checkpoint.every=1 ms\", \"run.end_time=3 ms\"]\nseeds = 2\nside_by_side = 1\n");
  ASSERT_EQ(study({"-o", "whole"}).exit_code, 0);
  {
    test::Background first(folder_.path(), {PF_BINARY, "study", "study.toml"});
    ASSERT_TRUE(has_checkpoint(folder_ / "out/members"));
    first.send(SIGKILL);
    EXPECT_EQ(first.end().exit_code, 128 + SIGKILL);
  }
  const auto second = study();
  ASSERT_EQ(second.exit_code, 0) << second.output;
  EXPECT_NE(second.output.find("goes on from its checkpoint"), std::string::npos) << second.output;
  const test::Csv members = test::read_csv(folder_ / "out/members.csv");
  ASSERT_EQ(members.rows.size(), 2);
  for (std::size_t row = 0; row < 2; ++row) {
    EXPECT_EQ(members.rows[row][3], "done");
    for (const char* table : {"/series.csv", "/tracks.csv", "/clogging.csv"}) {
      const std::string name = members.rows[row][2] + table;
      EXPECT_EQ(test::read_text(folder_ / ("out/members/" + name)),
                test::read_text(folder_ / ("whole/members/" + name)));
    }
  }
}

TEST_F(StudyRun, a_member_that_fails_is_tried_again_and_says_why) {
  place(9e-6);
  write(test::throat_case, "[[axis]]\nkey = \"run.max_wall\"\nvalues = [\"1 us\", \"1 h\"]\n");
  const auto result = study();
  EXPECT_EQ(result.exit_code, 3) << result.output;
  EXPECT_NE(result.output.find("will be tried again: max_wall"), std::string::npos)
      << result.output;
  EXPECT_NE(result.output.find("1 of 2 members failed"), std::string::npos) << result.output;
  const test::Csv members = test::read_csv(folder_ / "out/members.csv");
  EXPECT_EQ(members.rows[0][3], "failed");
  EXPECT_EQ(members.at(0, "attempts_failed"), 2);
  EXPECT_EQ(members.rows[0].back(), "max_wall");
  EXPECT_EQ(members.rows[1][3], "done");
}

TEST_F(StudyRun, is_refused_under_mpirun_and_where_nothing_fits) {
  write(test::slit_case, "seeds = 2\n");
  const auto many = test::run_on(2, folder_, {PF_BINARY, "study", "study.toml"});
  EXPECT_EQ(many.exit_code, 2) << many.output;
  EXPECT_NE(many.output.find("run it without mpirun"), std::string::npos) << many.output;
  write(test::slit_case, "seeds = 2\nset = [\"grid.cell_size=10 nm\"]\n");
  const auto large = study({"--dry-run"});
  EXPECT_EQ(large.exit_code, 2) << large.output;
  EXPECT_NE(large.output.find("study.toml"), std::string::npos) << large.output;
}

/// Members on two ranks each.
TEST_F(StudyRun, members_may_have_several_ranks) {
  write(test::slit_case, "ranks = 2\nset = [\"run.end_time=0.2 ms\"]\nseeds = 1\n");
  const auto result = study();
  ASSERT_EQ(result.exit_code, 0) << result.output;
  EXPECT_EQ(test::number(test::read_text(member(0) + "/summary.json"), "ranks"), 2);
}

/// Every study that comes with the program is one: its members are valid cases.
TEST(ShippedStudies, plan_themselves) {
  int found = 0;
  for (const auto& entry : fs::directory_iterator(PF_SOURCE_DIR "/studies")) {
    const fs::path file = entry.path() / "study.toml";
    if (!fs::exists(file)) {
      continue;
    }
    ++found;
    const test::Scratch folder;
    const auto result = test::porefines_in(folder.path(), {"study", file.string(), "--dry-run",
                                                           "-o", (folder.path() / "out").string()});
    EXPECT_EQ(result.exit_code, 0) << result.output;
    EXPECT_NE(result.output.find("in all"), std::string::npos) << result.output;
    EXPECT_TRUE(fs::exists(entry.path() / "README.md"));
  }
  EXPECT_GE(found, 6);
}

}  // namespace
}  // namespace porefines
