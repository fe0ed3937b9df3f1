// SPDX-License-Identifier: MPL-2.0
// Grains that jam in a hopper under gravity: the clogging log tells what the contact forces did.
#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "analysis/clogging.hpp"
#include "analysis/gather_sample.hpp"
#include "cli/run_support.hpp"
#include "core/atomic_file.hpp"
#include "support/program.hpp"
#include "support/scratch.hpp"

namespace porefines {
namespace {

constexpr Vec3 box{3.2e-3, 2e-3, 0.22e-3};
constexpr Real diameter = 0.2e-3;

/// Two cylinders 1.75 diameters apart.
geom::Sample hopper() {
  geom::Sample sample;
  sample.spec.kind = geom::Kind::cylinders;
  sample.box = {box, {geom::Beyond::mirror, geom::Beyond::mirror, geom::Beyond::mirror}};
  sample.bodies = {{{2e-3, 0, 0}, 0.825e-3}, {{2e-3, 2e-3, 0}, 0.825e-3}};
  return sample;
}

const std::string hopper_case = R"(gravity = ["9.81 m/s^2", "0", "0"]
[run]
end_time = "0.15 s"
random_seed = 2
[geometry]
kind = "cylinders"
source = "cylinders.txt"
size = ["3.2 mm", "2 mm", "0.22 mm"]
[box]
open = ["x+"]
[[particles]]
diameter = "0.2 mm"
young = "0.2 MPa"
count = 40
region = { low = ["0 mm", "0 mm", "0 mm"], high = ["1.1 mm", "2 mm", "0.22 mm"] }
[contact]
friction = 0.5
restitution = 0.3
max_overlap = 0.2
[[output]]
kind = "tracks"
every = "2 ms"
)";

/// Samples by time, from the tracks of a run.
std::map<Real, analysis::OwnedSample> read_samples(const test::Csv& tracks,
                                                   const geom::Solid& grains) {
  const auto gap = [&](const Vec3& x) {
    return std::min({signed_distance(grains, x), x.y, box.y - x.y, x.z, box.z - x.z});
  };
  std::map<Real, analysis::OwnedSample> samples;
  for (std::size_t row = 0; row < tracks.rows.size(); ++row) {
    const Vec3 x{tracks.at(row, "x_m"), tracks.at(row, "y_m"), tracks.at(row, "z_m")};
    const Vec3 v{tracks.at(row, "u_m_s"), tracks.at(row, "v_m_s"), tracks.at(row, "w_m_s")};
    const Real r = tracks.at(row, "diameter_m") / 2;
    if (x.x <= box.x) {
      const Real time = tracks.at(row, "time_s");
      samples[time].scalars.time = time;
      samples[time].put(static_cast<std::uint64_t>(tracks.at(row, "id")), x, v, r,
                        analysis::touch_wall(gap, x, r));
    }
  }
  return samples;
}

}  // namespace

TEST(Hopper, that_jams_is_one_arch_with_all_the_others_behind_it) {
  const test::Scratch folder;
  write_file(folder / "cylinders.txt", "2.0e-3 0 0.825e-3\n2.0e-3 2e-3 0.825e-3\n");
  write_file(folder / "case.toml", hopper_case);
  const auto result = test::porefines_in(folder.path(), {"run", "case.toml"});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const geom::PoreNetwork network = geom::find_network(hopper(), 0);
  ASSERT_EQ(network.throats.size(), 1U);
  EXPECT_NEAR(network.throats[0].width, 1.75 * diameter, 0.01 * diameter);

  const auto rules = analysis::default_rest_rules(diameter, 0.05);  // about sqrt(g d)
  analysis::CloggingState state;
  std::vector<analysis::ClogEvent> events;
  for (auto& [time, sample] : read_samples(test::read_csv(folder / "out/tracks.csv"),
                                           make_solid(hopper(), {}, box, 1e-3))) {
    sample.scalars.fluid_speed = 0.05;
    sample.scalars.out = 40 - static_cast<Index>(sample.id.size());
    const auto news = update_clogging(state, sample.view(), network, rules);
    events.insert(events.end(), news.begin(), news.end());
  }
  const Index out = 40 - static_cast<Index>(state.fates.size());
  EXPECT_GT(out, 0);
  EXPECT_LT(out, 20);
  ASSERT_EQ(state.clogs.size(), 1U);
  EXPECT_EQ(state.clogs[0].kind, analysis::ClogKind::arch);
  EXPECT_GE(state.clogs[0].ids.size(), 2U);
  EXPECT_LE(state.clogs[0].ids.size(), 5U);
  const analysis::FateCounts& counts = state.counts;
  EXPECT_EQ(counts.all(), 40);
  EXPECT_EQ(counts.piping, out);
  EXPECT_EQ(counts.bridging, static_cast<Index>(state.clogs[0].ids.size()));
  EXPECT_EQ(counts.clogged, state.clogs[0].behind);
  EXPECT_EQ(counts.resting, 0);
  const auto released = std::count_if(events.begin(), events.end(), [](const auto& event) {
    return event.what == analysis::ClogEvent::What::released;
  });
  const auto clogged = std::count_if(events.begin(), events.end(), [](const auto& event) {
    return event.what == analysis::ClogEvent::What::clogged;
  });
  EXPECT_EQ(clogged, released + 1);
  EXPECT_LE(released, 1);
}

}  // namespace porefines
