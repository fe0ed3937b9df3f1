// SPDX-License-Identifier: MPL-2.0
// Pore volume along the flow and pressures at throats are the same on any number of ranks.
#include <cmath>

#include <gtest/gtest.h>

#include "analysis/gather_sample.hpp"
#include "analysis/retention.hpp"
#include "analysis/throat_pressure.hpp"

namespace porefines::analysis {
namespace {

constexpr Int3 cells{32, 16, 16};
constexpr Vec3 spacing{0.5, 0.5, 0.25};
constexpr Vec3 origin{-1, 0, 0};

struct Readings {
  std::vector<Real> pores;
  std::vector<ThroatPressure> pressures;
};

Readings read_on(const par::Communicator& comm) {
  par::LayerWork work;
  for (std::size_t a = 0; a < 3; ++a) {
    work[a].assign(static_cast<std::size_t>(cells[a]), 1);
  }
  const auto cut = par::decompose(cells, comm.size(), work);
  const grid::Block block = grid::make_block(cut, comm.rank(), {}, 1);
  std::vector<float> solid;
  std::vector<float> pressure;
  for (int k = 0; k < block.n[2]; ++k) {
    for (int j = 0; j < block.n[1]; ++j) {
      for (int i = 0; i < block.n[0]; ++i) {
        const int global = block.start[0] + i;
        solid.push_back(global % 4 == 0 ? 0.25F : 0);
        pressure.push_back(static_cast<float>(global + block.start[1] + j));
      }
    }
  }
  geom::PoreNetwork network;
  network.size = {16, 8, 4};
  for (const Real x : {3.0, 7.1}) {
    geom::Throat throat;
    throat.centre = {x, 4, 2};
    throat.normal = {1, 0, 0};
    throat.across = {0, 1, 0};
    throat.width = 2;
    throat.area = 3;
    network.throats.push_back(throat);
  }
  network = geom::share_network(comm.is_root() ? network : geom::PoreNetwork{}, comm.handle());
  const auto probes = place_probes(
      network, [](const Vec3&) { return 1.0; }, 0.5);
  return {pore_volumes_along(solid, block, spacing, origin.x, {0, -1, 14, 5}, comm),
          read_throats(probes, CellReader{pressure, {}, &block, spacing, origin}, comm)};
}

TEST(RunReadingsOnRanks, are_the_same_as_on_one) {
  const Readings together = read_on(par::Communicator());
  const Readings alone = read_on(par::Communicator::self());
  ASSERT_EQ(together.pores.size(), 5U);
  for (std::size_t b = 0; b < 5; ++b) {
    EXPECT_NEAR(together.pores[b], alone.pores[b], 1e-10 * alone.pores[b]);
  }
  ASSERT_EQ(together.pressures.size(), 2U);
  for (std::size_t t = 0; t < 2; ++t) {
    EXPECT_NEAR(together.pressures[t].behind, alone.pressures[t].behind, 1e-10);
    EXPECT_NEAR(alone.pressures[t].drop(), -4, 1e-10);  // windows 2 apart, 1 per half
  }
}

TEST(RunReadingsOnRanks, samples_come_together_in_order_of_id) {
  const par::Communicator comm;
  OwnedSample mine;
  mine.scalars.time = comm.is_root() ? 2.5 : -1;
  for (std::uint64_t id = 0; id < 50; ++id) {  // dealt out in some order
    if (static_cast<int>(id * 7 % 5) % comm.size() == comm.rank()) {
      const auto x = static_cast<Real>(49 - id);
      mine.put(49 - id, {x, 0, 0}, {0, x, 0}, x + 1, {-x, {0, 0, 1}});
    }
  }
  const OwnedSample all = gather_sample(mine, comm);
  ASSERT_EQ(all.id.size(), comm.is_root() ? 50U : 0U);
  const RunSample sample = all.view();
  for (std::size_t i = 0; i < sample.id.size(); ++i) {
    EXPECT_EQ(sample.id[i], i);
    EXPECT_EQ(sample.position[i].x, static_cast<Real>(i));
    EXPECT_EQ(sample.velocity[i].y, static_cast<Real>(i));
    EXPECT_EQ(sample.radius[i], static_cast<Real>(i + 1));
    EXPECT_EQ(sample.wall_gap[i], -static_cast<Real>(i));
    EXPECT_EQ(sample.wall_normal[i].z, 1);
  }
  EXPECT_TRUE(!comm.is_root() || sample.time == 2.5);
}

}  // namespace
}  // namespace porefines::analysis
