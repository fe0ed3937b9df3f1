// SPDX-License-Identifier: MPL-2.0
// Study files, their members, and what repeats become.
#include "study/study.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "study/collect.hpp"
#include "study/groups.hpp"
#include "study/plan.hpp"
#include "support/scratch.hpp"

namespace porefines::study {
namespace {

constexpr auto slit = R"([geometry]
kind = "empty"
size = ["48 um", "16 um", "16 um"]
[grid]
cell_size = "1 um"
[flow]
inlet = { face = "x-", pressure = "20 Pa" }
outlet = { face = "x+", pressure = "0 Pa" }
walls = ["z-", "z+"]
slip = ["y-", "y+"]
)";

class StudyFile : public ::testing::Test {
 protected:
  StudyFile() { write_file(folder_ / "case.toml", slit); }
  [[nodiscard]] Study parse(const std::string& text) const {
    return parse_study("case = \"case.toml\"\n" + text, folder_ / "study.toml");
  }
  /// What a study is refused with.
  [[nodiscard]] std::string complaint(const std::string& text) const {
    try {
      (void)expand(parse(text));
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }
  test::Scratch folder_;
};

TEST_F(StudyFile, axes_multiply_and_seeds_repeat) {
  const Study study = parse(R"(seeds = 3
first_seed = 5
[[axis]]
key = "flow.inlet.pressure"
values = ["10 Pa", "20 Pa"]
[[axis]]
keys = ["fluid.viscosity", "fluid.density"]
values = [["1 mPa s", "1000 kg/m^3"], ["2 mPa s", "1100 kg/m^3"]]
at = [1, 2]
)");
  const std::vector<Member> members = expand(study);
  ASSERT_EQ(members.size(), 12);
  EXPECT_EQ(members[4].group, 1);
  EXPECT_EQ(members[4].seed, 6);
  EXPECT_EQ(members[4].settings,
            (std::vector<std::string>{"flow.inlet.pressure=10 Pa", "fluid.viscosity=2 mPa s",
                                      "fluid.density=1100 kg/m^3", "run.random_seed=6"}));
  EXPECT_EQ(study.axes[0].unit, "Pa");
  EXPECT_DOUBLE_EQ(study.axes[0].points[1].at, 20);
  EXPECT_DOUBLE_EQ(study.axes[1].points[1].at, 2);
}

TEST_F(StudyFile, points_are_called_by_their_place_or_their_first_value) {
  const auto names_of = [&](const std::string& axis) {
    const Study study = parse(
        "[[axis]]\nname = \"liquid\"\nkeys = [\"fluid.viscosity\", \"fluid.density\"]\n" + axis);
    std::vector<std::string> names;
    for (const Member& member : expand(study)) {
      names.push_back(describe_group(study, member));
    }
    return names;
  };
  const std::string values =
      "values = [[\"1 mPa s\", \"1000 kg/m^3\"], [\"2 mPa s\", \"1100 kg/m^3\"]]\n";
  EXPECT_EQ(names_of(values), (std::vector<std::string>{"liquid 1 mPa s", "liquid 2 mPa s"}));
  EXPECT_EQ(names_of(values + "at = [0.05, 3]\n"),
            (std::vector<std::string>{"liquid 0.05", "liquid 3"}));
  EXPECT_EQ(names_of("values = [[\"1 mPa s\", \"1000 kg/m^3\"], [\"1 mPa s\", \"1100 kg/m^3\"]]\n"),
            (std::vector<std::string>{"liquid 1 mPa s 1000 kg/m^3", "liquid 1 mPa s 1100 kg/m^3"}));
}

/// Adding repeats keeps the folders of those that are done.
TEST_F(StudyFile, members_keep_their_folders_when_a_study_grows) {
  const std::string axis =
      "[[axis]]\nkey = \"flow.inlet.pressure\"\nvalues = [\"10 Pa\", \"20 Pa\"]\n";
  const auto before = expand(parse("seeds = 1\n" + axis));
  const auto after = expand(parse("seeds = 2\n" + axis));
  EXPECT_EQ(before[1].name, after[2].name);
  EXPECT_NE(before[1].name, after[3].name);
  write_file(folder_ / "case.toml", slit + std::string("tolerance = 1e-5\n"));
  EXPECT_NE(before[1].name, expand(parse("seeds = 1\n" + axis))[1].name);
}

TEST_F(StudyFile, ranges_are_linear_or_logarithmic_with_their_unit) {
  const auto values = [&](const std::string& more) {
    std::vector<std::string> out;
    const Study study = parse("[[axis]]\nkey = \"flow.inlet.pressure\"\n" + more);
    for (const AxisPoint& point : study.axes.front().points) {
      out.push_back(point.values.front());
    }
    return out;
  };
  using Texts = std::vector<std::string>;
  EXPECT_EQ(values("from = \"1 Pa\"\nto = \"2 Pa\"\ncount = 3\n"),
            (Texts{"1 Pa", "1.5 Pa", "2 Pa"}));
  EXPECT_EQ(values("from = \"1 Pa\"\nto = \"100 Pa\"\ncount = 3\nspacing = \"log\"\n"),
            (Texts{"1 Pa", "10 Pa", "100 Pa"}));
  EXPECT_EQ(values("from = 1\nto = 3\ncount = 3\n"), (Texts{"1", "2", "3"}));
}

TEST_F(StudyFile, values_of_the_command_line_win) {
  const std::string text =
      "case = \"case.toml\"\nseeds = 3\n[[axis]]\nkey = \"flow.inlet.pressure\"\nvalues = [\"10 "
      "Pa\"]\n";
  const Study study = parse_study(
      text, folder_ / "study.toml",
      {"seeds=2", "set=[\"fluid.viscosity=2 mPa s\"]", "axis.0.values=[\"10 Pa\", \"30 Pa\"]"});
  EXPECT_EQ(expand(study).size(), 4U);
  EXPECT_EQ(study.settings, std::vector<std::string>{"fluid.viscosity=2 mPa s"});
}

TEST_F(StudyFile, mistakes_name_their_line_and_what_to_try) {
  const auto expect = [&](const std::string& text, const std::string& part) {
    const std::string found = complaint(text);
    EXPECT_NE(found.find(part), std::string::npos) << found;
  };
  expect("", "changes nothing");
  expect("seed = 3\n", "did you mean seeds?");
  expect("[[axis]]\nvalues = [1]\n", "needs a key");
  expect("[[axis]]\nkey = \"run.random_seed\"\n", "needs from");
  expect("[[axis]]\nkey = \"run.random_seed\"\nvalues = []\n", "has no values");
  expect("seeds = 2\n[[axis]]\nkey = \"run.random_seed\"\nvalues = [1, 2]\n", "keep seeds");
  expect("[[axis]]\nkeys = [\"a.b\", \"c.d\"]\nvalues = [[1, 2], [3]]\n", "1 values for 2 keys");
  expect("[[axis]]\nkey = \"flow.inlet.pressure\"\nfrom = \"1 Pa\"\nto = \"1 kPa\"\ncount = 3\n",
         "write both in the same unit");
  expect("seeds = 2\nreadings = [\"series.x\"]\n", "is no reading");
  expect("[[axis]]\nkey = \"flow.inlet.presure\"\nvalues = [\"1 Pa\"]\n", "line 2");
  expect("[[axis]]\nkey = \"flow.inlet.presure\"\nvalues = [\"1 Pa\"]\n", "pressure");
  expect("[[axis]]\nkey = \"flow.inlet.pressure\"\nvalues = [\"1 Pa\", \"1.0 Pa\"]\n",
         "two members are the same run");
  EXPECT_THROW((void)parse_study("seeds = 2\n", "x.toml"), InputError);
  EXPECT_THROW((void)read_study(folder_ / "none.toml"), InputError);
}

TEST(StudyPlan, cores_and_memory_decide_how_many_run_side_by_side) {
  Study study;
  EXPECT_EQ(choose_side_by_side(study, 8, 100, 10), 8);
  EXPECT_EQ(choose_side_by_side(study, 8, 100, 30), 3);
  study.ranks = 4;
  EXPECT_EQ(choose_side_by_side(study, 8, 100, 10), 2);
  study.ranks = 16;
  EXPECT_EQ(choose_side_by_side(study, 8, 100, 10), 1);
  study.ranks = 1;
  study.side_by_side = 5;
  EXPECT_EQ(choose_side_by_side(study, 8, 100, 10), 5);
  EXPECT_THROW((void)choose_side_by_side(study, 8, 100, 101), InputError);
}

TEST(Collect, reads_what_a_run_has_written) {
  const test::Scratch folder;
  write_file(
      folder / "summary.json",
      "{\n  \"status\": \"done\",\n  \"reason\": \"max_clogged_throats\",\n  \"time_s\": 3,\n"
      "  \"pore_volumes_injected\": 6,\n  \"particles_out\": 9\n}\n");
  write_file(folder / "series.csv",
             "time_s,pore_volumes,permeability_ratio\n0,0,1\n1,2,0.5\n3,6,nan\n3.5,7,0.2");
  write_file(folder / "clogging.csv",
             "time_s,pore_volumes,event,out\n0.5,1,grown,3\n2,4,clogged,5\n");
  const auto result =
      collect(folder.path(), {"particles_out", "series.permeability_ratio.min",
                              "series.permeability_ratio.last", "clogging.time_s", "none"});
  ASSERT_TRUE(result);
  EXPECT_DOUBLE_EQ(result->readings[0], 9);
  EXPECT_DOUBLE_EQ(result->readings[1], 0.5);  // the row cut short does not count
  EXPECT_DOUBLE_EQ(result->readings[2], 0.5);
  EXPECT_DOUBLE_EQ(result->readings[3], 2);
  EXPECT_TRUE(std::isnan(result->readings[4]));
  EXPECT_TRUE(result->escapees.happened);
  EXPECT_DOUBLE_EQ(result->escapees.at, 5);
  EXPECT_TRUE(result->curves[0].holds);
  EXPECT_EQ(result->curves[0].x, (std::vector<Real>{0, 2}));
  write_file(folder / "clogging.csv", "time_s,pore_volumes,event,out\n");
  const auto censored = collect(folder.path(), {});
  EXPECT_FALSE(censored->escapees.happened);
  EXPECT_DOUBLE_EQ(censored->escapees.at, 9);
  EXPECT_DOUBLE_EQ(censored->volumes.at, 6);
  write_file(folder / "summary.json", "{\n  \"status\": \"interrupted\"\n}\n");
  EXPECT_FALSE(collect(folder.path(), {}));
}

TEST_F(StudyFile, repeats_become_shares_and_means) {
  const Study study = parse("seeds = 4\nreadings = [\"k\"]\n");
  const std::vector<Member> members = expand(study);
  std::vector<std::optional<Result>> results(4);
  for (std::size_t i = 0; i < 3; ++i) {  // the fourth failed
    Result result;
    result.readings = {static_cast<Real>(i)};
    result.clogs = true;
    result.escapees = {10.0 * static_cast<Real>(i + 1), i < 2};
    result.time = result.volumes = result.escapees;
    results[i] = result;
  }
  const std::vector<Group> groups = make_groups(study, members, results);
  ASSERT_EQ(groups.size(), 1);
  EXPECT_EQ(groups[0].members, 4);
  EXPECT_EQ(groups[0].done, 3);
  EXPECT_EQ(groups[0].clogged.hits, 2);
  EXPECT_EQ(groups[0].clogged.trials, 3);
  EXPECT_DOUBLE_EQ(groups[0].readings[0].value, 1);
  EXPECT_DOUBLE_EQ(analysis::fit_exponential(groups[0].escapees, 0.95).mean, 30);
}

}  // namespace
}  // namespace porefines::study
