// SPDX-License-Identifier: MPL-2.0
// All readings of a run together: the tables they fill, and that a restart goes on with them.
#include "analysis/readings.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "analysis/gather_sample.hpp"
#include "core/error.hpp"
#include "support/scratch.hpp"

namespace porefines::analysis {
namespace {

std::string content(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A slit of height 10 along x with a throat of width 2 in its middle; lengths in m.
ReadingSetup slit() {
  ReadingSetup setup;
  setup.network.size = {40, 10, 1};
  setup.network.flat = true;
  setup.network.pores.resize(2);
  geom::Throat throat;
  throat.centre = {20, 5, 0.5};
  throat.across = {0, 1, 0};
  throat.normal = {1, 0, 0};
  throat.width = throat.area = 2;
  throat.behind = throat.ahead = 1;
  setup.network.throats.push_back(throat);
  setup.bins = {0, 0, 40, 4};
  setup.pore_volumes = {100, 100, 100, 100};
  setup.area = 10;
  setup.rest.hold_time = 2;
  return setup;
}

/// At time t one particle a second has come in, 5 m/s fast; the third is too large and stays.
OwnedSample at_time(int t) {
  OwnedSample sample;
  sample.scalars.time = t;
  sample.scalars.pore_volumes = 0.0625 * t;
  sample.scalars.fluid_speed = 5;
  for (int id = 0; id < t; ++id) {
    const Real x = 5.0 * (t - id);
    const bool large = id == 2;
    const bool stays = large && x >= 18;
    if (x < 40 || stays) {
      sample.put(static_cast<std::uint64_t>(id), {stays ? 18.0 : x, 5, 0.5},
                 {stays ? 0.0 : 5.0, 0, 0}, large ? 1.1 : 0.3, {stays ? 0.0 : 3.0, {-1, 0, 0}});
    } else {
      ++sample.scalars.out;
    }
  }
  return sample;
}

void tell(int from, int to, ReadingState& state, const ReadingSetup& setup, ReadingTables& tables,
          std::vector<std::vector<Real>>& rows) {
  for (int t = from; t <= to; ++t) {
    const OwnedSample sample = at_time(t);
    const Real out = static_cast<Real>(sample.scalars.out) * 0.1;
    rows.push_back(reading_row(take_reading(state, setup, sample.view(), {20.0 * t, 0.1 * t, out},
                                            {{3.0, 1.0 + t}}, &tables)));
  }
}

}  // namespace

TEST(Readings, fill_their_tables_sample_by_sample) {
  const test::Scratch folder;
  const ReadingSetup setup = slit();
  ReadingTables tables(folder.path().string(), setup.network);
  ReadingState state;
  std::vector<std::vector<Real>> rows;
  tell(1, 12, state, setup, tables, rows);
  const std::string clogging = content(folder / "clogging.csv");
  EXPECT_EQ(std::count(clogging.begin(), clogging.end(), '\n'), 2) << clogging;
  EXPECT_NE(clogging.find("\n8,0.5,0,20,5,0.5,2,clogged,sieve,1,0,1,2\n"), std::string::npos)
      << clogging;
  const std::string retention = content(folder / "retention.csv");
  EXPECT_EQ(std::count(retention.begin(), retention.end(), '\n'), 1 + 4 * 12);
  EXPECT_NE(retention.find("\n12,0.75,15,1,0.01,"), std::string::npos) << retention;
  const std::string pressure = content(folder / "throats_pressure.csv");
  EXPECT_NE(pressure.find("\n12,0.75,0,3,13,-10\n"), std::string::npos) << pressure;
  EXPECT_EQ(content(folder / "throats.csv").rfind("id,x_m", 0), 0U);
  ASSERT_EQ(reading_columns().size(), rows.back().size());
  EXPECT_NEAR(rows.back()[0], 0.005, 1e-12);     // inlet
  EXPECT_NEAR(rows.back()[2], 1, 1e-9);          // C/C0: small ones pass
  EXPECT_NEAR(rows.back()[5], 1.0 / 12, 1e-12);  // one of twelve is sieved
  EXPECT_EQ(rows.back()[7], 1);                  // throat
  EXPECT_EQ(rows.front()[7], 0);
}

TEST(Readings, go_on_after_a_restart_as_if_nothing_had_happened) {
  const test::Scratch whole;
  const test::Scratch halves;
  const ReadingSetup setup = slit();
  std::vector<std::vector<Real>> expected;
  {
    ReadingTables tables(whole.path().string(), setup.network);
    ReadingState state;
    tell(1, 12, state, setup, tables, expected);
  }
  std::vector<std::vector<Real>> rows;
  std::vector<Real> kept;
  {
    ReadingTables tables(halves.path().string(), setup.network);
    ReadingState state;
    tell(1, 7, state, setup, tables, rows);
    kept = pack(state);
    std::vector<std::vector<Real>> lost;
    tell(8, 9, state, setup, tables, lost);  // killed after the checkpoint
  }
  ReadingState state = unpack_readings(kept);
  ReadingTables tables(halves.path().string(), setup.network, 7.0);
  tell(8, 12, state, setup, tables, rows);
  for (std::size_t n = 0; n < expected.size(); ++n) {
    for (std::size_t c = 0; c < expected[n].size(); ++c) {
      EXPECT_TRUE(rows[n][c] == expected[n][c] ||
                  (std::isnan(rows[n][c]) && std::isnan(expected[n][c])));
    }
  }
  for (const char* const name : {"clogging.csv", "retention.csv", "throats_pressure.csv"}) {
    EXPECT_EQ(content(whole / name), content(halves / name)) << name;
  }
  EXPECT_THROW((void)unpack_readings(std::vector<Real>{1, 2}), RunError);
}

}  // namespace porefines::analysis
