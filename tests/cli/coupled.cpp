// SPDX-License-Identifier: MPL-2.0
// Fluid and particles from the case file to the results.
#include <csignal>

#include <gtest/gtest.h>

#include "cli/coupled_support.hpp"

namespace porefines {
namespace {

using test::number;
using test::read_text;
using test::slit_case;
using test::throat_case;

using Coupled = test::Coupled;

TEST_F(Coupled, suspension_goes_through_a_slit) {
  const auto result = run(slit_case);
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const std::string json = summary();
  const double injected = number(json, "particles_injected");
  EXPECT_GT(injected, 5);
  EXPECT_GT(number(json, "particles_out"), 0);
  EXPECT_EQ(injected, number(json, "particles_inside") + number(json, "particles_out"));
  EXPECT_LT(number(json, "permeability_ratio"), 0.999);
  EXPECT_GT(number(json, "permeability_ratio"), 0.7);
  EXPECT_LE(number(json, "cycles_per_solve"), 7);
  // What was asked for is what came in: 5 % of the flow, but for the particle that is still due.
  const double volume = injected * 65.45e-18;
  const double passed = number(json, "pore_volumes_injected") * 48e-6 * 256e-12;
  EXPECT_NEAR(volume / passed, 0.05, 1.5 * 65.45e-18 / passed);
}

TEST_F(Coupled, goes_on_after_kill_bit_for_bit) {
  const auto whole = run(slit_case, {"-o", "whole"});
  ASSERT_EQ(whole.exit_code, 0) << whole.output;
  test::Background running(folder_.path(), {PF_BINARY, "run", "case.toml", "-o", "out"});
  ASSERT_TRUE(running.wait_for("checkpoint at 0.00")) << running.end().output;
  running.send(SIGKILL);
  running.end();
  const auto resumed = run(slit_case, {"-o", "out", "--restart"});
  ASSERT_EQ(resumed.exit_code, 0) << resumed.output;
  for (const std::string table : {"tracks.csv", "series.csv", "retention.csv", "clogging.csv"}) {
    EXPECT_EQ(read_text(folder_ / ("out/" + table)), read_text(folder_ / ("whole/" + table)));
  }
}

TEST_F(Coupled, same_on_two_ranks_to_the_solvers_tolerance) {
  ASSERT_EQ(run(slit_case, {"-o", "one", "run.end_time=4 ms"}).exit_code, 0);
  const auto two = run(slit_case, {"-o", "two", "run.end_time=4 ms"}, 2);
  ASSERT_EQ(two.exit_code, 0) << two.output;
  const std::string a = summary("one");
  const std::string b = summary("two");
  EXPECT_EQ(number(a, "particles_injected"), number(b, "particles_injected"));
  for (const std::string key : {"permeability_ratio", "mean_speed_m_s", "sigma_x_m"}) {
    EXPECT_NEAR(number(b, key) / number(a, key), 1, 1e-3) << key;
  }
}

TEST_F(Coupled, a_fine_larger_than_the_throat_is_sieved_and_stays) {
  place(9e-6);
  const auto result = run(throat_case);
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const std::string json = summary();
  EXPECT_EQ(number(json, "particles_inside"), 1);
  EXPECT_EQ(number(json, "wall_contacts"), 2);
  EXPECT_LT(number(json, "permeability_ratio"), 0.8);
  EXPECT_LT(number(json, "mean_speed_m_s"), 1e-3 * 1.3e-3) << "a thousandth of its speed before";
  EXPECT_LT(number(json, "max_overlap"), 0.01);
}

/// Modulus and bound of this case would let the fine sink in by 7 % of its radius, and did end the run; where
/// particles creep they are made as stiff as the bound asks.
TEST_F(Coupled, soft_fines_become_as_stiff_as_the_bound_of_overlaps_asks) {
  place(9e-6);
  const auto result = run(throat_case, {"particles.0.young=3 kPa", "contact.max_overlap=0.005"});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  EXPECT_EQ(number(summary(), "wall_contacts"), 2);
  EXPECT_LT(number(summary(), "mean_speed_m_s"), 1e-3 * 1.3e-3);
}

/// Nothing but contacts holds it, so four times the pressure holds it as well, pressed a little deeper; the
/// flow back takes it along.
TEST_F(Coupled, a_sieved_fine_stays_at_a_higher_drive_and_leaves_at_one_backwards) {
  place(9e-6);
  const std::string changes =
      "[[drive]]\nfrom = \"10 ms\"\nfactor = 4\n[[drive]]\nfrom = \"13 ms\"\nfactor = -1\n";
  ASSERT_EQ(run(throat_case + changes, {"run.end_time=9 ms"}).exit_code, 0);
  const double before = number(summary(), "permeability_ratio");
  EXPECT_LT(before, 0.3);
  ASSERT_EQ(run(throat_case + changes, {"run.end_time=12 ms", "--restart"}).exit_code, 0);
  EXPECT_LT(number(summary(), "permeability_ratio"), before);
  EXPECT_NEAR(number(summary(), "pressure_drop_pa") / 40, 1, 0.1);
  EXPECT_LT(number(summary(), "max_overlap"), 0.01);
  ASSERT_EQ(run(throat_case + changes, {"run.end_time=24 ms", "--restart"}).exit_code, 0);
  EXPECT_GT(number(summary(), "permeability_ratio"), 0.95);
  EXPECT_EQ(number(summary(), "wall_contacts"), 0);
}

TEST_F(Coupled, a_fine_smaller_than_the_throat_passes) {
  place(6e-6);
  const auto result = run(throat_case);
  ASSERT_EQ(result.exit_code, 0) << result.output;
  EXPECT_EQ(number(summary(), "particles_out"), 1);
  EXPECT_NEAR(number(summary(), "permeability_ratio"), 1, 1e-4);
}

TEST_F(Coupled, a_pump_keeps_its_rate) {
  std::string content = slit_case;
  content.replace(content.find("pressure = \"20 Pa\""), 18, "flow_rate = \"0.5 nL/s\"");
  const auto result = run(content, {"run.end_time=4 ms"});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  EXPECT_NEAR(number(summary(), "flow_rate_m3_s") / 0.5e-12, 1, 1e-3);
}

TEST_F(Coupled, a_velocity_with_fines_is_kept_as_by_a_pump) {
  const auto tracks_with = [&](const std::string& inlet) {
    std::string content = slit_case;
    content.replace(content.find("pressure = \"20 Pa\""), 18, inlet);
    const auto result = run(content, {"run.end_time=4 ms"});
    EXPECT_EQ(result.exit_code, 0) << result.output;
    return test::read_csv(folder_ / "out/tracks.csv");
  };
  const test::Csv rate = tracks_with("flow_rate = \"0.512 nL/s\"");
  const test::Csv velocity = tracks_with("velocity = \"2 mm/s\"");
  ASSERT_EQ(velocity.rows.size(), rate.rows.size());
  ASSERT_GE(rate.rows.size(), 2U);
  for (std::size_t i = 0; i < rate.rows.size(); ++i) {
    EXPECT_NEAR(velocity.at(i, "x_m") / rate.at(i, "x_m"), 1, 1e-9);
  }
  EXPECT_NEAR(number(summary(), "flow_rate_m3_s") / 0.512e-12, 1, 1e-3);
}

TEST_F(Coupled, a_pump_against_a_plugged_throat_settles) {
  place(9e-6);
  std::string content = throat_case;
  content.replace(content.find("pressure = \"10 Pa\""), 18, "flow_rate = \"0.5 nL/s\"");
  const auto result = run(content, {"run.end_time=20 ms"});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const std::string json = summary();
  EXPECT_EQ(number(json, "wall_contacts"), 2);
  EXPECT_NEAR(number(json, "flow_rate_m3_s") / 0.5e-12, 1, 1e-3);
  EXPECT_LT(number(json, "mean_speed_m_s"),
            1e-3 * number(json, "flow_rate_m3_s") / (24e-6 * 12e-6));
  EXPECT_LT(number(json, "contact_substeps"), 2000) << "a clog at rest is no work for the contacts";
}

TEST_F(Coupled, limits_end_the_run_with_their_reason) {
  const auto result = run(slit_case, {"run.max_pore_volumes=0.2"});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  EXPECT_NE(summary().find("pore volumes have passed"), std::string::npos) << summary();
}

TEST_F(Coupled, its_case_file_runs_again) {
  ASSERT_EQ(run(slit_case, {"run.end_time=1 ms"}).exit_code, 0);
  const auto again =
      test::run_in(folder_.path(), {PF_BINARY, "run", "out/case.toml", "-o", "again"});
  ASSERT_EQ(again.exit_code, 0) << again.output;
  EXPECT_EQ(read_text(folder_ / "out/series.csv"), read_text(folder_ / "again/series.csv"));
}

TEST_F(Coupled, wrong_input_is_refused) {
  std::string content = slit_case;
  content.replace(content.find("face = \"x-\"\nvolume"), 11, "face = \"z+\"");
  const auto face = run(content);
  EXPECT_EQ(face.exit_code, 2);
  EXPECT_NE(face.output.find("is no opening of the flow"), std::string::npos) << face.output;
  content = slit_case;
  content.replace(content.find("end_time = \"6 ms\""), 17, "");
  const auto endless = run(content);
  EXPECT_EQ(endless.exit_code, 2);
  EXPECT_NE(endless.output.find("end_time"), std::string::npos) << endless.output;
}

}  // namespace
}  // namespace porefines
