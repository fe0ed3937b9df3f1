// SPDX-License-Identifier: MPL-2.0
// What is read off a coupled run, and what its steps may not change.
#include <csignal>

#include <gtest/gtest.h>

#include "cli/coupled_support.hpp"

namespace porefines {
namespace {

using test::number;
using test::read_csv;
using test::read_text;
using test::slit_case;
using test::throat_case;
using Readings = test::Coupled;

const std::string quick_hold = "clogging.hold_time=10 ms";

TEST_F(Readings, a_sieved_fine_is_logged_where_it_sits) {
  place(9e-6);
  const auto result =
      run(throat_case + "[[output]]\nkind = \"movie\"\nevery = \"4 ms\"\n", {quick_hold});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const test::Csv log = read_csv(folder_ / "out/clogging.csv");
  ASSERT_EQ(log.rows.size(), 1U);
  EXPECT_NEAR(log.at(0, "width_m"), 8e-6, 0.02 * 8e-6);
  EXPECT_NEAR(log.at(0, "x_m"), 20e-6, 0.3e-6);
  EXPECT_EQ(log.rows[0][7], "clogged");
  EXPECT_EQ(log.rows[0][8], "sieve");
  EXPECT_EQ(log.rows[0].back(), "0") << "id";

  const test::Csv series = read_csv(folder_ / "out/series.csv");
  const std::size_t last = series.rows.size() - 1;
  EXPECT_EQ(series.at(0, "piping_share"), 1);
  EXPECT_EQ(series.at(last, "clogged_share"), 1);
  EXPECT_EQ(series.at(last, "clogged_throats"), 1);

  // Nine tenths of the drop over the sample now fall at the throat.
  const test::Csv pressure = read_csv(folder_ / "out/throats_pressure.csv");
  ASSERT_EQ(pressure.rows.size(), series.rows.size());
  EXPECT_GT(pressure.at(last, "pressure_drop_pa"), 0.9 * series.at(last, "pressure_drop_pa"));
  EXPECT_LT(pressure.at(0, "pressure_drop_pa"), 0.8 * series.at(0, "pressure_drop_pa"));

  // Its volume stands in the bins that it lies in, as solid.
  const test::Csv retention = read_csv(folder_ / "out/retention.csv");
  constexpr std::size_t bins = 50;
  ASSERT_EQ(retention.rows.size(), bins * series.rows.size());
  double retained = 0;
  double missing = 0;
  for (std::size_t row = retention.rows.size() - bins; row < retention.rows.size(); ++row) {
    retained += retention.at(row, "retained");
    missing += retention.at(row, "porosity_clean") - retention.at(row, "porosity");
  }
  EXPECT_EQ(retained, 1);
  const double bin_volume = 40e-6 / bins * 24e-6 * 12e-6;
  EXPECT_NEAR(missing * bin_volume / (3.14159265 / 6 * 729e-18), 1, 0.02);
  EXPECT_GT(read_text(folder_ / "out/movie.mp4").size(), 1000U);
}

/// Everything of a clog goes on from a checkpoint: N + N steps are 2 N.
TEST_F(Readings, go_on_bit_for_bit_with_a_clog) {
  place(9e-6);
  ASSERT_EQ(run(throat_case, {quick_hold, "-o", "whole"}).exit_code, 0);
  ASSERT_EQ(run(throat_case, {quick_hold, "run.end_time=44 ms"}).exit_code, 0);
  const auto rest = run(throat_case, {quick_hold, "--restart"});
  ASSERT_EQ(rest.exit_code, 0) << rest.output;
  for (const std::string table :
       {"tracks", "series", "clogging", "retention", "throats_pressure"}) {
    EXPECT_EQ(read_text(folder_ / ("out/" + table + ".csv")),
              read_text(folder_ / ("whole/" + table + ".csv")))
        << table;
  }
}

/// What plugs a throat neither creeps on nor trembles, for a thousand steps.
TEST_F(Readings, a_plugged_throat_stays_as_it_is) {
  place(9e-6);
  const auto result = run(throat_case, {"run.end_time=0.2 s",
                                        "output=[{kind=\"summary\", "
                                        "every=\"0.1 ms\"}]"});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const test::Csv series = read_csv(folder_ / "out/series.csv");
  const std::size_t count = series.rows.size();
  ASSERT_GE(count, 2001U);
  const std::size_t last = count - 1;
  for (std::size_t row = count - 1001; row < count; ++row) {
    for (const std::string name : {"flow_rate_m3_s", "pressure_drop_pa", "mean_x_m", "mean_y_m"}) {
      ASSERT_NEAR(series.at(row, name) / series.at(last, name), 1, 1e-3) << name << " " << row;
    }
    ASSERT_LT(series.at(row, "mean_speed_m_s"), 1e-3 * 1.3e-3) << row;
  }
  EXPECT_LE(number(summary(), "cycles_per_solve"), 3);
}

/// Travel 1, 0.5 and 0.125 cells a step: where fines have come to differs by less than 0.2 d.
TEST_F(Readings, shorter_steps_lead_to_the_same_places) {
  constexpr double d = 5e-6;
  write_file(folder_ / "fine.csv",
             "x_m,y_m,z_m,diameter_m\n4e-6,6e-6,6.2e-6,5e-6\n5e-6,12.3e-6,4e-6,5e-6\n"
             "11e-6,16e-6,7e-6,5e-6\n");
  ASSERT_EQ(run(throat_case, {"run.end_time=30 ms", "-o", "short", "coupling.travel=0.125",
                              "coupling.tolerance=1e-5"})
                .exit_code,
            0);
  const test::Csv b = read_csv(folder_ / "short/tracks.csv");
  for (const std::string travel : {"0.5", "1"}) {
    ASSERT_EQ(run(throat_case, {"run.end_time=30 ms", "-o", travel, "coupling.travel=" + travel})
                  .exit_code,
              0);
    const test::Csv a = read_csv(folder_ / (travel + "/tracks.csv"));
    EXPECT_GT(number(summary("short"), "steps"), 2.5 * number(summary(travel), "steps"));
    ASSERT_NEAR(static_cast<double>(a.rows.size()), static_cast<double>(b.rows.size()), 1)
        << "one may leave before the last of these samples";
    double worst = 0;
    std::size_t compared = 0;
    for (std::size_t q = 0; q < a.rows.size(); ++q) {
      for (std::size_t p = 0; p < b.rows.size(); ++p) {
        if (a.at(q, "id") == b.at(p, "id") &&
            std::abs(a.at(q, "time_s") - b.at(p, "time_s")) < 1e-9) {
          ++compared;
          for (const std::string axis : {"x_m", "y_m", "z_m"}) {
            worst = std::max(worst, std::abs(a.at(q, axis) - b.at(p, axis)) / d);
          }
        }
      }
    }
    if (travel == "0.5") {
      EXPECT_EQ(a.rows.size(), b.rows.size());
    }
    EXPECT_GE(compared + 3, b.rows.size()) << "the last rows tell the moments of leaving";
    std::printf("[ measured ] %s cells a step: largest difference %.3f d\n", travel.c_str(), worst);
    EXPECT_LT(worst, 0.2);
  }
}

/// Lighter and heavier than the fluid, and exactly as heavy: steps do not depend on it.
TEST_F(Readings, any_density_is_stable) {
  constexpr double start = 6.2e-6;
  for (const double density : {900.0, 1000.0, 8000.0}) {
    place(5e-6);
    const std::string out = fmt::format("rho{:.0f}", density);
    const auto done =
        run(throat_case,
            {"run.end_time=6 ms", "gravity=500 m/s^2", "fluid.density=1000 kg/m^3",
             fmt::format("particles=[{{source=\"fine.csv\", density=\"{} kg/m^3\"}}]", density),
             "-o", out});
    ASSERT_EQ(done.exit_code, 0) << done.output;
    const test::Csv series = read_csv(folder_ / (out + "/series.csv"));
    const double rise = series.at(series.rows.size() - 1, "mean_z_m") - start;
    std::printf("[ measured ] %g kg/m^3 rises by %.3g um\n", density, 1e6 * rise);
    if (density == 1000) {
      EXPECT_LT(std::abs(rise), 0.05e-6);
    } else {
      EXPECT_GT(rise * (1000 - density), 0);
    }
    EXPECT_LT(number(summary(out), "max_overlap"), 0.01);
  }
}

/// The disk fills up on the way: the run says so, and once there is room it goes on.
TEST_F(Readings, a_full_disk_loses_nothing_that_was_written) {
  ASSERT_EQ(run(slit_case, {"-o", "whole"}).exit_code, 0);
  test::Background running(folder_.path(), {PF_BINARY, "run", "case.toml"});
  ASSERT_TRUE(running.wait_for("checkpoint at 0.00")) << running.end().output;
  running.limit_files(1000);  // less than any table holds by now
  const auto full = running.end();
  EXPECT_EQ(full.exit_code, 3) << full.output;
  EXPECT_NE(full.output.find(".csv: cannot append a row"), std::string::npos) << full.output;
  EXPECT_NE(full.output.find("--restart"), std::string::npos) << full.output;
  ASSERT_EQ(run(slit_case, {"--restart"}).exit_code, 0);
  for (const std::string table : {"tracks.csv", "series.csv", "retention.csv"}) {
    EXPECT_EQ(read_text(folder_ / ("out/" + table)), read_text(folder_ / ("whole/" + table)));
  }
}

/// A rank that dies takes the run with it at once; what was written is there, and it goes on.
TEST_F(Readings, a_killed_rank_ends_the_run_and_it_goes_on) {
  ASSERT_EQ(run(slit_case, {"-o", "whole"}, 2).exit_code, 0);
  test::Background running(folder_.path(),
                           {"mpirun", "--oversubscribe", "-n", "2", PF_BINARY, "run", "case.toml"});
  ASSERT_TRUE(running.wait_for("checkpoint at 0.00")) << running.end().output;
  const std::vector<pid_t> ranks = running.children();
  ASSERT_EQ(ranks.size(), 2U);
  kill(ranks.back(), SIGKILL);
  const auto dead = running.end();
  EXPECT_NE(dead.exit_code, 0) << dead.output;
  ASSERT_EQ(run(slit_case, {"--restart"}, 2).exit_code, 0);
  EXPECT_EQ(read_text(folder_ / "out/tracks.csv"), read_text(folder_ / "whole/tracks.csv"));
}

}  // namespace
}  // namespace porefines
