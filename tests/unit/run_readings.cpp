// SPDX-License-Identifier: MPL-2.0
// What researchers read from a run: spread, breakthrough, retention, pressure across throats.
#include <cmath>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "analysis/breakthrough.hpp"
#include "analysis/moments.hpp"
#include "analysis/retention.hpp"
#include "analysis/throat_pressure.hpp"

namespace porefines::analysis {
namespace {

/// Particles of a sample that the test owns.
struct Particles {
  std::vector<std::uint64_t> id;
  std::vector<Vec3> x, v;
  std::vector<Real> r, gap;
  std::vector<Vec3> normal;
  std::vector<Fate> fates;

  void put(const Vec3& at, Real radius, Fate fate) {
    id.push_back(id.size()), x.push_back(at), v.push_back({}), r.push_back(radius);
    gap.push_back(0), normal.push_back({}), fates.push_back(fate);
  }
  [[nodiscard]] RunSample sample() const { return {1.5, 0.25, 1, 0, id, x, v, r, gap, normal}; }
};

constexpr Real ball = 4 * std::numbers::pi / 3;

geom::PoreNetwork slanted_throat() {
  geom::PoreNetwork network;
  network.size = {20, 20, 4};
  network.flat = true;
  geom::Throat throat;
  throat.centre = {10, 10, 2};
  throat.normal = {0.8, 0.6, 0};
  throat.across = {-0.6, 0.8, 0};
  throat.width = 2;
  throat.area = 8;
  throat.behind = 1;
  throat.ahead = 2;
  network.throats.push_back(throat);
  return network;
}

}  // namespace

TEST(Moments, of_four_particles_are_those_of_the_formula) {
  MomentSums sums;
  sums.add({1, 0, 0}, {3, 4, 0});
  sums.add({2, 2, 0}, {0, 0, 1});
  sums.add({3, 0, 0}, {});
  sums.add({6, 2, 0}, {});
  const Moments m = moments_of(sums);
  EXPECT_DOUBLE_EQ(m.mean_speed, 1.5);
  EXPECT_DOUBLE_EQ(m.mean.x, 3);
  EXPECT_DOUBLE_EQ(m.sigma.x, std::sqrt(14.0 / 4));  // squares about the mean: 4 + 1 + 0 + 9
  EXPECT_DOUBLE_EQ(m.sigma.y, 1);
  EXPECT_EQ(moments_of({}).sigma, Vec3{});
}

TEST(Breakthrough, of_a_delayed_step_rises_from_nothing_to_one) {
  BreakthroughMeter meter;
  for (int n = 1; n <= 20; ++n) {  // fed from sample 3 on, arrives 5 samples later, a tenth stays
    const Real fed = std::max(n - 3, 0);
    const Real arrived = 0.9 * std::max(n - 8, 0);
    const auto c = take_breakthrough(meter, {2.0 * n, 0.008 * fed, 0.008 * arrived}, 0);
    EXPECT_NEAR(c.inlet, n > 3 ? 0.004 : 0, 1e-12) << n;
    EXPECT_NEAR(c.outlet, n > 8 ? 0.0036 : 0, 1e-12) << n;
    if (n <= 3) {
      EXPECT_TRUE(std::isnan(c.ratio)) << n;
    } else {
      EXPECT_NEAR(c.ratio, n > 8 ? 0.9 : 0, 1e-12) << n;
    }
  }
}

TEST(Breakthrough, refers_to_what_was_asked_for_and_outlasts_a_pulse) {
  BreakthroughMeter asked;
  BreakthroughMeter measured;
  Throughput now;
  Real tail = 0;
  for (int n = 0; n < 30; ++n) {
    now.flow += 1;
    now.injected += n < 10 ? 0.01 : 0;
    now.out += n >= 5 && n < 15 ? 0.01 : 0;
    EXPECT_NEAR(take_breakthrough(asked, now, 0.02).ratio, n >= 5 && n < 15 ? 0.5 : 0, 1e-12);
    tail = take_breakthrough(measured, now, 0).ratio;
    EXPECT_NEAR(tail, n >= 5 && n < 15 ? 1 : 0, 1e-12) << n;  // not diluted by the clean flow after
  }
  EXPECT_TRUE(std::isnan(take_breakthrough(measured, now, 0).outlet));  // nothing flowed
}

TEST(Retention, a_sphere_across_an_edge_is_cut_there) {
  Particles p;
  p.put({4, 1, 1}, 1, Fate::bridging);     // centre on the edge between the bins 1 and 2
  p.put({4.5, 3, 3}, 1, Fate::resting);    // 5/32 of it below the edge
  p.put({0.2, 5, 5}, 0.5, Fate::clogged);  // partly before the first bin
  p.put({9, 5, 5}, 1, Fate::piping);
  const ProfileBins bins{0, 0, 10, 5};
  const RetentionProfile got = retention_along(p.sample(), p.fates, bins);
  EXPECT_NEAR(got.retained_volume[1], ball * (0.5 + 5.0 / 32), 1e-12);
  EXPECT_NEAR(got.retained_volume[2], ball * (0.5 + 27.0 / 32), 1e-12);
  EXPECT_NEAR(got.retained_volume[0], ball * 0.125 - sphere_below(0.5, -0.2), 1e-12);
  EXPECT_EQ(got.retained, (std::vector<Index>{1, 0, 2, 0, 0}));
  EXPECT_NEAR(got.suspended_volume[4], ball, 1e-12);
  EXPECT_EQ(got.suspended_volume[3], 0);
}

TEST(Retention, rows_give_shares_of_the_pore_volume_and_the_porosity_left) {
  Particles p;
  p.put({1, 1, 1}, 0.5, Fate::clogged);
  p.put({1, 2, 1}, 0.5, Fate::piping);
  const ProfileBins bins{0, 0, 4, 2};
  const std::string rows = retention_rows(p.sample(), retention_along(p.sample(), p.fates, bins),
                                          std::vector<Real>{4, 0}, 4, bins);
  EXPECT_EQ(rows,
            "1.5,0.25,1,1,0.25,0.130899694,0.130899694,0.5,0.434550153\n"
            "1.5,0.25,3,0,0,0,0,0,0\n");
  EXPECT_EQ(retention_columns().size(), 9U);
}

TEST(Retention, pore_volume_goes_to_bins_by_length) {
  grid::Block block;
  block.global = block.n = {6, 2, 2};
  std::vector<float> solid(24, 0);
  for (std::size_t row = 0; row < 4; ++row) {
    solid[6 * row + 1] = 0.5F;
    solid[6 * row + 5] = 1;
  }
  const auto pore = pore_volumes_along(solid, block, {0.5, 1, 1}, -0.5, {0, 0, 2.25, 3},
                                       par::Communicator::self());
  ASSERT_EQ(pore.size(), 3U);  // cells begin at -0.5, edges at 0, 0.75, 1.5, 2.25
  EXPECT_NEAR(pore[0], 4 * (0.25 + 0.25), 1e-12);
  EXPECT_NEAR(pore[1], 4 * 0.75, 1e-12);
  EXPECT_NEAR(pore[2], 4 * 0.5, 1e-12);  // 1.5 to 2; the cell from 2 to 2.5 is rock
}

TEST(ThroatPressure, of_a_linear_field_is_its_difference_between_the_windows) {
  const geom::PoreNetwork network = slanted_throat();
  const Vec3 gradient{-3, 2, 0.5};
  const auto probes = place_probes(
      network, [](const Vec3&) { return 1.0; }, 0.5);
  EXPECT_EQ(probes.points.size(), 2U * 8 * 8 * 8);
  const auto field = [&](const Vec3& x) { return 7 + dot(gradient, x); };
  const auto read = read_throats(probes, field, par::Communicator::self());
  ASSERT_EQ(read.size(), 1U);
  const Real along = dot(gradient, network.throats[0].normal);
  EXPECT_NEAR(read[0].behind, field(network.throats[0].centre) - 2 * along, 1e-12);
  EXPECT_NEAR(read[0].ahead, field(network.throats[0].centre) + 3 * along, 1e-12);
  EXPECT_NEAR(read[0].drop(), -5 * along, 1e-12);
}

TEST(ThroatPressure, leaves_out_grains_what_lies_behind_them_and_what_is_covered) {
  const geom::PoreNetwork network = slanted_throat();
  const Vec3 n = network.throats[0].normal;
  const Vec3 centre = network.throats[0].centre;
  // a thin wall 2.5 ahead: half of the window ahead lies behind it
  const auto distance = [&](const Vec3& x) { return std::abs(dot(x - centre, n) - 2.5) - 0.3; };
  const auto probes = place_probes(network, distance, 0.5);
  for (std::size_t i = 0; i < probes.points.size(); ++i) {
    EXPECT_LT(dot(probes.points[i] - centre, n), 2.2);
  }
  const auto covered = [&](const Vec3& x) { return dot(x - centre, n) < 0 ? std::nan("") : 1.0; };
  const auto read = read_throats(probes, covered, par::Communicator::self());
  EXPECT_TRUE(std::isnan(read[0].behind));
  EXPECT_EQ(read[0].ahead, 1);
}

TEST(ThroatPressure, across_a_periodic_face_keeps_the_mean_gradient) {
  geom::PoreNetwork network = slanted_throat();
  network.periodic = {true, true, false};
  network.throats[0].centre = {19.5, 19.9, 2};
  const auto probes = place_probes(
      network, [](const Vec3&) { return 1.0; }, 0.5);
  for (const Vec3& x : probes.points) {
    EXPECT_TRUE(x.x >= 0 && x.x < 20 && x.y >= 0 && x.y < 20);
  }
  const auto read =
      read_throats(probes, [](const Vec3&) { return 0.0; }, par::Communicator::self(), {-3, 0, 0});
  EXPECT_NEAR(read[0].drop(), 3 * 5 * 0.8, 1e-12);
}

}  // namespace porefines::analysis
