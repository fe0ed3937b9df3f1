// SPDX-License-Identifier: MPL-2.0
// Cases of cases/ with spheres that have mass, as a user runs them: half an hour in all on one core.
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "cli/run_support.hpp"

namespace porefines::test {
namespace {

/// Runs a case of cases/ into `out` of a folder.
Csv tracks_of(const Scratch& folder, const std::string& name, const std::vector<std::string>& more,
              int ranks = 1) {
  std::vector<std::string> words{
      PF_BINARY, "run", std::string(PF_SOURCE_DIR) + "/cases/" + name + "/case.toml", "-o", "out"};
  words.insert(words.end(), more.begin(), more.end());
  const ProgramResult result = run_on(ranks, folder, words);
  EXPECT_EQ(result.exit_code, 0) << result.output;
  return read_csv(folder / "out/tracks.csv");
}

/// First times at which the rear sphere has come nearer, touches, and lies beside or below the other one; 0:
/// never.
struct Phases {
  double drafting = 0, kissing = 0, tumbling = 0;
};

Phases phases_of(const Csv& tracks, double diameter) {
  Phases found;
  double first = 0;
  for (std::size_t i = 0; i + 1 < tracks.rows.size(); i += 2) {
    const double dx = tracks.at(i + 1, "x_m") - tracks.at(i, "x_m");
    const double dy = tracks.at(i + 1, "y_m") - tracks.at(i, "y_m");
    const double dz = tracks.at(i + 1, "z_m") - tracks.at(i, "z_m");
    const double distance = std::hypot(dx, dy, dz) / diameter;
    const double time = tracks.at(i, "time_s");
    first = i == 0 ? distance : first;
    const auto note = [&](double& when, bool now) { when = when == 0 && now ? time : when; };
    note(found.drafting,
         distance < 0.9 * first && tracks.at(i + 1, "w_m_s") < tracks.at(i, "w_m_s"));
    note(found.kissing, distance < 1.01);
    note(found.tumbling, dz < 0 && found.kissing > 0);
  }
  return found;
}

}  // namespace

/// Glowinski et al. (2001) on six cells a diameter. Found on one rank: 0.21, 0.33, 0.49 s.
TEST(InertialCases, drafting_kissing_tumbling_on_one_and_two_ranks) {
  for (const int ranks : {1, 2}) {
    const Scratch folder;
    const Phases found = phases_of(tracks_of(folder, "tumbling", {}, ranks), 1.0 / 600);
    std::printf("%d ranks: drafting %.3f, kissing %.3f, tumbling %.3f s\n", ranks, found.drafting,
                found.kissing, found.tumbling);
    EXPECT_GT(found.drafting, 0);
    EXPECT_GT(found.kissing, found.drafting);
    EXPECT_GT(found.tumbling, found.kissing);
  }
}

/// r/R = 0.6 +- 0.05 (Segre & Silberberg) from both sides, nearer than 0.03 to each other at the end.
TEST(InertialCases, neutral_sphere_in_a_tube_goes_to_three_fifths_of_its_radius) {
  const auto end = [](const std::string& start) {
    const Scratch folder;
    const std::string list = std::string(PF_SOURCE_DIR) + "/cases/tube_migration/" + start + ".csv";
    const Csv tracks = tracks_of(folder, "tube_migration", {"particles.0.source=" + list});
    const std::size_t last = tracks.rows.size() - 1;
    return std::hypot(tracks.at(last, "x_m") - 1.6e-3, tracks.at(last, "y_m") - 1.6e-3) / 1.5e-3;
  };
  const double inside = end("inside");
  const double outside = end("outside");
  std::printf("r/R %.4f from 0.5, %.4f from 0.68\n", inside, outside);
  EXPECT_NEAR(inside, 0.6, 0.05);
  EXPECT_NEAR(outside, 0.6, 0.05);
  EXPECT_LT(inside, outside + 0.005);
  EXPECT_LT(outside - inside, 0.03);
}

/// Rebound over impact speed grows with the Stokes number and stays below the dry 0.97, and steps ten times as short
/// change it by less than 0.02.
TEST(InertialCases, wet_rebound_grows_with_the_stokes_number_whatever_the_step) {
  const auto restitution = [](const std::vector<std::string>& more) {
    const Scratch folder;
    const Csv tracks = tracks_of(folder, "wet_impact", more);
    double down = 0;
    double up = 0;
    for (std::size_t i = 0; i < tracks.rows.size(); ++i) {
      const double w = tracks.at(i, "w_m_s");
      up = -w > down ? 0 : std::max(up, w);
      down = std::max(down, -w);
    }
    return up / down;
  };
  const double usual = restitution({});
  const double finer = restitution({"coupling.travel=0.05"});
  const double thick = restitution({"fluid.viscosity=30 mPa s"});
  const double thicker = restitution({"fluid.viscosity=200 mPa s"});
  std::printf("e %.3f (steps of a tenth %.3f) at St 114, %.3f at 38, %.3f at 6\n", usual, finer,
              thick, thicker);
  EXPECT_NEAR(finer, usual, 0.02);
  EXPECT_LT(usual, 0.97);
  EXPECT_GT(usual, thick + 0.1);
  EXPECT_LT(thicker, 0.05);
}

}  // namespace porefines::test
