// SPDX-License-Identifier: MPL-2.0
// The bundled cases of particles without a fluid, made small, at the shell, on one and two ranks.
#include <csignal>
#include <filesystem>
#include <sstream>

#include <gtest/gtest.h>

#include "cli/run_support.hpp"
#include "core/atomic_file.hpp"

namespace porefines {
namespace {

using test::Csv;
using test::number;
using test::read_csv;
using test::read_text;

/// Runs a bundled case into `folder`/out; returns summary.json.
std::string run_case(const test::Scratch& folder, const std::string& name, int ranks,
                     const std::vector<std::string>& overrides) {
  std::vector<std::string> words{PF_BINARY, "run", PF_SOURCE_DIR "/cases/" + name + "/case.toml",
                                 "-o", "out"};
  words.insert(words.end(), overrides.begin(), overrides.end());
  const auto result = test::run_on(ranks, folder, words);
  EXPECT_EQ(result.exit_code, 0) << result.output;
  return read_text(folder / "out/summary.json");
}

class DryCases : public ::testing::TestWithParam<int> {
 protected:
  test::Scratch folder_;
};

TEST_P(DryCases, settling_loses_energy_and_no_grain) {
  const std::string summary =
      run_case(folder_, "settling", GetParam(), {"run.end_time=25 ms", "particles.0.count=60"});
  EXPECT_EQ(number(summary, "particles_inside"), 60);
  EXPECT_EQ(number(summary, "particles_injected"), 60);
  EXPECT_EQ(number(summary, "particles_out"), 0);
  const Csv series = read_csv(folder_ / "out/series.csv");
  ASSERT_EQ(series.rows.size(), 26U);
  const double start = series.at(0, "energy_j");
  for (std::size_t row = 1; row < series.rows.size(); ++row) {
    EXPECT_NEAR(series.at(row, "time_s"), 1e-3 * static_cast<double>(row), 1e-12);
    // What is lost never comes back: within 1e-4 of the energy that falls, the error of the steps.
    EXPECT_GE(series.at(row, "energy_lost_j"), series.at(row - 1, "energy_lost_j") - 1e-4 * start);
    EXPECT_NEAR(series.at(row, "dissipated_j"), series.at(row, "energy_lost_j"), 2e-3 * start)
        << "added up by contacts, against the balance";
    EXPECT_NEAR(series.at(row, "energy_j") + series.at(row, "energy_lost_j"), start, 1e-9 * start);
  }
  EXPECT_NEAR(series.at(3, "energy_lost_j"), 0, 0.1 * start) << "they still fall";
  EXPECT_LT(series.at(25, "mean_z_m"), 0.5 * series.at(0, "mean_z_m"));
  const Csv tracks = read_csv(folder_ / "out/tracks.csv");
  EXPECT_EQ(tracks.rows.size(), 60U * 6);
  EXPECT_EQ(tracks.names[12], "state");
  EXPECT_EQ(tracks.rows[59][1], "59") << "sorted by id";
  EXPECT_EQ(tracks.rows[60][12], "mobile");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/particles.png"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/case.toml"));
}

TEST_P(DryCases, incline_rolls_and_slides_as_newton_says) {
  const std::string summary = run_case(folder_, "incline", GetParam(), {});
  EXPECT_EQ(number(summary, "particles_inside"), 2);
  const Csv tracks = read_csv(folder_ / "out/tracks.csv");
  const std::size_t last = tracks.rows.size() - 2;
  const double t = tracks.at(last, "time_s");
  EXPECT_NEAR(t, 0.1, 1e-12);
  // From rest: a = (5/7) g sin(slope), v = a t; a ball thrown at v0 without spin first slides.
  const double g = 9.81;
  const double along = g * std::sin(20 * std::acos(-1.0) / 180);
  EXPECT_NEAR(tracks.at(last, "x_m"), 2e-3 + 5.0 / 14 * along * t * t,
              5e-3 * 5.0 / 14 * along * t * t);
  EXPECT_NEAR(tracks.at(last, "u_m_s"), 5.0 / 7 * along * t, 5e-3 * 5.0 / 7 * along * t);
  EXPECT_NEAR(tracks.at(last, "wy_rad_s") * 0.5e-3, tracks.at(last, "u_m_s"), 2e-3);
  // Momentum about the point of contact: v (7/5) r = v0 r + g sin(slope) r t, sliding or rolling.
  const double thrown = 5.0 / 7 * (0.2 + along * t);
  EXPECT_NEAR(tracks.at(last + 1, "u_m_s"), thrown, 5e-3 * thrown);
}

TEST_P(DryCases, hopper_empties_through_the_slot) {
  const std::string summary =
      run_case(folder_, "hopper", GetParam(), {"run.end_time=40 ms", "particles.0.count=120"});
  const double out = number(summary, "particles_out");
  EXPECT_GT(out, 5);
  EXPECT_EQ(number(summary, "particles_inside") + out, 120);
  const Csv tracks = read_csv(folder_ / "out/tracks.csv");
  int last_rows = 0;
  for (const auto& row : tracks.rows) {
    last_rows += row[12] == "out" ? 1 : 0;
  }
  EXPECT_EQ(last_rows, out) << "each that leaves says so once";
}

TEST_P(DryCases, packing_is_dense_and_stays) {
  const std::string summary =
      run_case(folder_, "packing", GetParam(),
               {"run.end_time=0.1 ms", "particles.0.diameter=200 um", "run.random_seed=3"});
  EXPECT_GT(number(summary, "coordination_number"), 5.5);
  EXPECT_LT(number(summary, "coordination_number"), 6.6);
  EXPECT_LT(number(summary, "max_overlap"), 0.01);
  EXPECT_LT(number(summary, "kinetic_j"), 0.02 * number(summary, "elastic_j"));
}

INSTANTIATE_TEST_SUITE_P(Ranks, DryCases, ::testing::Values(1, 2));

/// Gravity downwards in a box of 2 mm.
std::string in_a_box(const std::string& end_time) {
  return "gravity = \"9.81 m/s^2\"\n[run]\nend_time = \"" + end_time +
         "\"\n[geometry]\nkind = \"empty\"\nsize = [\"2 mm\", \"2 mm\", \"2 mm\"]\n";
}

const std::string injected_case = in_a_box("30 ms") + R"([box]
open = ["z-"]
[[particles]]
diameter = { mean = "0.2 mm", standard_deviation = "0.02 mm" }
young = "1 MPa"
[injection]
face = "z+"
rate = "2000 Hz"
velocity = "0.1 m/s"
stop = "20 ms"
[contact]
max_overlap = 0.05
)";

TEST(DryRun, what_enters_leaves_and_the_ledger_knows) {
  const test::Scratch folder;
  write_file(folder / "case.toml", injected_case);
  const auto result = test::porefines_in(folder.path(), {"run", "case.toml"});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const std::string summary = read_text(folder / "out/summary.json");
  EXPECT_EQ(number(summary, "particles_injected"), 40);
  EXPECT_GT(number(summary, "particles_out"), 10);
  EXPECT_EQ(number(summary, "particles_out") + number(summary, "particles_inside"), 40);
  EXPECT_EQ(number(summary, "particles_waiting"), 0);
}

TEST(DryRun, says_when_the_rate_cannot_be_met) {
  const test::Scratch folder;
  write_file(folder / "case.toml", injected_case);
  const auto result = test::porefines_in(
      folder.path(), {"run", "case.toml", "injection.rate=1 MHz", "run.end_time=2 ms",
                      "output=[{ kind = \"pictures\", every = \"1 ms\" }]"});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  EXPECT_GT(number(read_text(folder / "out/summary.json"), "particles_waiting"), 1000);
  EXPECT_NE(result.output.find("found no room at the inlet"), std::string::npos) << result.output;
  for (const std::string picture : {"_00000", "_00001", "_00002", ""}) {
    EXPECT_TRUE(std::filesystem::exists(folder / ("out/particles" + picture + ".png"))) << picture;
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "out/tracks.csv")) << "not asked for";
}

TEST(DryRun, a_dry_run_tells_the_numbers_and_moves_nothing) {
  const test::Scratch folder;
  write_file(folder / "case.toml", injected_case);
  const auto result = test::porefines_in(folder.path(), {"run", "case.toml", "--dry-run"});
  EXPECT_EQ(result.exit_code, 0) << result.output;
  for (const std::string word :
       {"40 to be injected", "contact    Hertz-Mindlin", "1/30 of it", "of memory, about"}) {
    EXPECT_NE(result.output.find(word), std::string::npos) << word << " in\n" << result.output;
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "out/summary.json"));
}

TEST(DryRun, elastic_impacts_keep_their_energy) {
  const test::Scratch folder;
  write_file(folder / "case.toml", in_a_box("50 ms") + R"([[particles]]
name = "large"
diameter = "0.3 mm"
young = "2 MPa"
count = 20
[[particles]]
name = "small"
diameter = "0.2 mm"
young = "2 MPa"
count = 20
[contact]
restitution = 1
friction = 0
max_overlap = 0.1
)");
  const auto result = test::porefines_in(folder.path(), {"run", "case.toml"});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const Csv series = read_csv(folder / "out/series.csv");
  const std::size_t last = series.rows.size() - 1;
  EXPECT_GT(series.at(last, "kinetic_j"), 0.1 * series.at(0, "energy_j")) << "they still bounce";
  // Velocity Verlet at 1/30 of a contact: 1e-4 of the energy in all these impacts together.
  EXPECT_NEAR(series.at(last, "energy_lost_j"), 0, 1e-3 * series.at(0, "energy_j"));
}

TEST(DryRun, grains_of_an_image_hold_particles) {
  const test::Scratch folder;
  ASSERT_EQ(test::porefines_in(folder.path(), {"generate", "micromodel", "--size", "0.2 mm",
                                               "0.2 mm", "--pixel-size", "2 um", "--grain", "60 um",
                                               "--porosity", "0.6", "-o", "chip.png"})
                .exit_code,
            0);
  write_file(folder / "case.toml", R"(gravity = ["0", "-9.81 m/s^2", "0"]
[run]
end_time = "0.5 ms"
[geometry]
source = "chip.png"
pixel_size = "2 um"
depth = "20 um"
keep = "all"
[[particles]]
diameter = "8 um"
young = "0.1 MPa"
count = 60
)");
  const auto result = test::porefines_in(folder.path(), {"run", "case.toml"});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const std::string summary = read_text(folder / "out/summary.json");
  EXPECT_EQ(number(summary, "particles_inside"), 60);
  EXPECT_LT(number(summary, "max_overlap"), 0.01);
}

TEST(DryRun, particles_rest_on_a_mesh) {
  const test::Scratch folder;
  const auto facet = [](const std::string& a, const std::string& b, const std::string& c) {
    return "facet normal 0 0 1\nouter loop\nvertex " + a + "\nvertex " + b + "\nvertex " + c +
           "\nendloop\nendfacet\n";
  };
  write_file(folder / "plate.stl", "solid plate\n" + facet("-1 -1 0", "3 -1 0", "3 3 0") +
                                       facet("-1 -1 0", "3 3 0", "-1 3 0") + "endsolid plate\n");
  write_file(folder / "list.csv", "x_m,y_m,z_m,diameter_m\n1e-3,1e-3,0.7e-3,0.2e-3\n");
  write_file(folder / "case.toml", in_a_box("60 ms") + R"([[particles]]
source = "list.csv"
young = "1 MPa"
[[surface]]
kind = "mesh"
source = "plate.stl"
unit = "1 mm"
point = ["0 mm", "0 mm", "0.5 mm"]
[contact]
restitution = 0.3
max_overlap = 0.05
)");
  const auto result = test::porefines_in(folder.path(), {"run", "case.toml"});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const Csv tracks = read_csv(folder / "out/tracks.csv");
  // At rest on the plate: half a millimetre up, and sunk in by less than 0.1 % of its diameter.
  EXPECT_NEAR(tracks.at(tracks.rows.size() - 1, "z_m"), 0.6e-3, 0.2e-6);
  EXPECT_NEAR(tracks.at(tracks.rows.size() - 1, "w_m_s"), 0, 1e-4);
}

TEST(DryRun, a_limit_on_wall_time_ends_it_with_its_results) {
  const test::Scratch folder;
  write_file(folder / "case.toml", injected_case);
  const auto result = test::porefines_in(
      folder.path(), {"run", "case.toml", "run.max_wall=1e-6 s", "run.end_time=1 h"});
  EXPECT_EQ(result.exit_code, 3) << result.output;
  EXPECT_NE(result.output.find("run.max_wall is over at "), std::string::npos) << result.output;
  EXPECT_NE(read_text(folder / "out/summary.json").find("max_wall"), std::string::npos);
}

TEST(DryRun, a_signal_ends_it_with_its_results) {
  const test::Scratch folder;
  write_file(folder / "case.toml", injected_case);
  test::Background run(
      folder.path(), {PF_BINARY, "run", "case.toml", "run.end_time=1 day", "injection.stop=1 day"});
  ASSERT_TRUE(run.wait_for("of memory")) << run.end().output;
  run.send(SIGTERM);
  const auto result = run.end();
  EXPECT_EQ(result.exit_code, 128 + SIGTERM) << result.output;
  EXPECT_NE(result.output.find("results are those so far"), std::string::npos) << result.output;
  const std::string summary = read_text(folder / "out/summary.json");
  EXPECT_NE(summary.find("\"status\": \"interrupted\""), std::string::npos) << summary;
  EXPECT_EQ(number(summary, "particles_injected"),
            number(summary, "particles_inside") + number(summary, "particles_out"));
}

TEST(DryRun, keeps_its_results_when_it_must_stop) {
  const test::Scratch folder;
  write_file(folder / "case.toml", injected_case);
  const auto result = test::porefines_in(
      folder.path(), {"run", "case.toml", "contact.max_overlap=1e-6", "box.open=[]"});
  EXPECT_EQ(result.exit_code, 3) << result.output;
  EXPECT_NE(result.output.find("try young = "), std::string::npos) << result.output;
  const std::string summary = read_text(folder / "out/summary.json");
  EXPECT_NE(summary.find("\"status\": \"stopped\""), std::string::npos) << summary;
  EXPECT_GT(read_csv(folder / "out/series.csv").rows.size(), 1U);
}

}  // namespace
}  // namespace porefines
