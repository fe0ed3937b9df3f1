// SPDX-License-Identifier: MPL-2.0
// The explicit coupling in whole runs, beside the implicit one.
#include <gtest/gtest.h>

#include "cli/coupled_support.hpp"

namespace porefines {
namespace {

using test::number;
using test::read_text;
using test::slit_case;
using test::throat_case;

using Explicit = test::Coupled;

const std::string explicitly = "coupling.method=explicit";

TEST_F(Explicit, leaks_through_a_plugged_throat_where_one_solve_is_tight) {
  place(9e-6);
  ASSERT_EQ(run(throat_case, {"-o", "one_solve"}).exit_code, 0);
  const auto result = run(throat_case, {"-o", "projected", explicitly});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const std::string json = summary("projected");
  EXPECT_EQ(number(json, "wall_contacts"), 2);
  EXPECT_LT(number(json, "mean_speed_m_s"), 1e-3 * 1.3e-3) << "a thousandth of its speed before";
  const double tight = number(summary("one_solve"), "permeability_ratio");
  const double leaky = number(json, "permeability_ratio");
  EXPECT_GT(leaky, 1.1 * tight);
  EXPECT_LT(leaky, 0.9);
}

/// Fines hardly obstruct what slips through them: less so in shorter steps, on one rank and on two.
TEST_F(Explicit, obstructs_a_slit_too_little_and_the_less_the_longer_its_steps) {
  const std::string end = "run.end_time=3 ms";
  ASSERT_EQ(run(slit_case, {"-o", "one_solve", end}).exit_code, 0);
  ASSERT_EQ(run(slit_case, {"-o", "long", end, explicitly}).exit_code, 0);
  ASSERT_EQ(run(slit_case, {"-o", "short", end, explicitly, "coupling.travel=0.1"}).exit_code, 0);
  const auto two = run(slit_case, {"-o", "two", end, explicitly}, 2);
  ASSERT_EQ(two.exit_code, 0) << two.output;
  const auto loss = [&](const std::string& folder) {
    return 1 - number(summary(folder), "permeability_ratio");
  };
  EXPECT_GT(loss("long"), 0);
  EXPECT_GT(loss("short"), 2 * loss("long"));
  EXPECT_GT(loss("one_solve"), 2 * loss("short"));
  EXPECT_NEAR(loss("two"), loss("long"), 1e-4);
  EXPECT_EQ(number(summary("long"), "particles_injected"),
            number(summary("one_solve"), "particles_injected"));
  EXPECT_NEAR(
      number(summary("long"), "mean_speed_m_s") / number(summary("one_solve"), "mean_speed_m_s"), 1,
      0.15);
}

TEST_F(Explicit, goes_on_bit_for_bit) {
  ASSERT_EQ(run(slit_case, {"-o", "whole", "run.end_time=4 ms", explicitly}).exit_code, 0);
  ASSERT_EQ(run(slit_case, {"-o", "parts", "run.end_time=2 ms", explicitly}).exit_code, 0);
  const auto second = run(slit_case, {"-o", "parts", "run.end_time=4 ms", explicitly, "--restart"});
  ASSERT_EQ(second.exit_code, 0) << second.output;
  for (const std::string table : {"tracks.csv", "series.csv"}) {
    EXPECT_EQ(read_text(folder_ / ("parts/" + table)), read_text(folder_ / ("whole/" + table)));
  }
}

TEST_F(Explicit, is_for_creeping_flow) {
  const auto result = run(slit_case, {explicitly, "flow.regime=navier-stokes"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.output.find("creeping flow"), std::string::npos) << result.output;
}

}  // namespace
}  // namespace porefines
