// SPDX-License-Identifier: MPL-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "scale/model.hpp"

namespace porefines::scale {
namespace {

constexpr Int3 cells{1340, 1000, 4};

/// Runs as the model itself would have them.
std::vector<Measured> made_up(const ScalingModel& truth) {
  std::vector<Measured> runs;
  for (const int ranks : {1, 2, 4, 8, 16}) {
    const Surface surface = surface_of(truth.cells, ranks);
    Measured run{.ranks = ranks};
    const Real compute = truth.fixed + truth.work * surface.share / ranks;
    if (ranks > 1) {
      run.messages = truth.messages_per_face * surface.neighbours;
      run.bytes = truth.bytes_per_cell * surface.cells;
      run.collectives = truth.collectives;
      run.halo = run.messages * truth.latency + run.bytes * truth.seconds_per_byte;
      run.reductions = truth.collectives * std::log2(ranks) * truth.hop;
      run.waiting = truth.waiting_share * compute;
    }
    run.seconds = compute + run.halo + run.reductions + run.waiting;
    runs.push_back(run);
  }
  return runs;
}

const ScalingModel truth{.cells = cells,
                         .fixed = 0.4,
                         .work = 20,
                         .messages_per_face = 500,
                         .bytes_per_cell = 2000,
                         .latency = 3e-6,
                         .seconds_per_byte = 2e-10,
                         .collectives = 300,
                         .hop = 2e-6,
                         .waiting_share = 0.05};

TEST(Scaling, coefficients_of_made_up_runs_come_back) {
  const ScalingModel found = fit_model(cells, made_up(truth));
  EXPECT_NEAR(found.fixed, truth.fixed, 1e-9);
  EXPECT_NEAR(found.work, truth.work, 1e-8);
  EXPECT_NEAR(found.messages_per_face, truth.messages_per_face, 1e-9);
  EXPECT_NEAR(found.bytes_per_cell, truth.bytes_per_cell, 1e-9);
  EXPECT_NEAR(found.latency, truth.latency, 1e-6 * truth.latency);
  EXPECT_NEAR(found.seconds_per_byte, truth.seconds_per_byte, 1e-6 * truth.seconds_per_byte);
  EXPECT_NEAR(found.hop, truth.hop, 1e-9 * truth.hop);
  EXPECT_NEAR(found.seconds(4096), truth.seconds(4096), 1e-6 * truth.seconds(4096));
}

TEST(Scaling, one_run_alone_gives_amdahl_without_messages) {
  const ScalingModel found = fit_model(cells, {{.ranks = 1, .seconds = 10}});
  EXPECT_NEAR(found.seconds(1), 10, 1e-9);
  EXPECT_GT(found.seconds(2), 4.9);
  EXPECT_LT(found.seconds(2), 10.1);
}

TEST(Scaling, surfaces_are_those_of_the_cut) {
  const Surface two = surface_of({64, 64, 1}, 2);
  EXPECT_EQ(two.neighbours, 1);
  EXPECT_DOUBLE_EQ(two.cells, 64);
  EXPECT_DOUBLE_EQ(two.share, 1);
  const Surface sixteen = surface_of({64, 64, 1}, 16);
  EXPECT_EQ(sixteen.neighbours, 4);
  EXPECT_DOUBLE_EQ(sixteen.cells, 64);
  EXPECT_EQ(surface_of({64, 64, 1}, 1).neighbours, 0);
  EXPECT_THROW((void)surface_of({16, 16, 1}, 4096), InputError);
}

TEST(Scaling, the_fewest_ranks_that_are_as_fast_are_recommended) {
  const auto run = [](int ranks, Real seconds) {
    return Measured{.ranks = ranks, .seconds = seconds};
  };
  EXPECT_EQ(recommend({run(1, 10), run(2, 5), run(4, 2.6), run(8, 2.5)}, 8), 4);
  EXPECT_EQ(recommend({run(1, 10), run(2, 5), run(4, 2.6), run(8, 1.0)}, 4), 4);  // hyper-threads
  EXPECT_EQ(recommend({run(1, 1), run(2, 1.5)}, 2), 1);
  EXPECT_EQ(ranks_to_try(6), (std::vector<int>{1, 2, 4, 6}));
  EXPECT_EQ(ranks_to_try(1), (std::vector<int>{1}));
}

}  // namespace
}  // namespace porefines::scale
