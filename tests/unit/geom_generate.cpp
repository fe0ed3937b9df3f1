// SPDX-License-Identifier: MPL-2.0
#include <numbers>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "geom/components.hpp"
#include "geom/metrics.hpp"
#include "geom/micromodel.hpp"
#include "geom/packing.hpp"
#include "unit/geom_support.hpp"

namespace porefines::geom {

namespace {

void expect_apart(const PackSpec& spec, const std::vector<Body>& bodies) {
  Real volume = 1;
  for (int axis = 0; axis < spec.dims; ++axis) {
    volume *= spec.size[axis];
  }
  Real grains = 0;
  for (std::size_t a = 0; a < bodies.size(); ++a) {
    const Real r = bodies[a].radius;
    grains += spec.dims == 2 ? std::numbers::pi * r * r : 4.0 / 3 * std::numbers::pi * r * r * r;
    for (std::size_t b = a + 1; b < bodies.size(); ++b) {
      Vec3 d = bodies[b].centre - bodies[a].centre;
      for (int axis = 0; spec.periodic && axis < spec.dims; ++axis) {
        d[axis] -= spec.size[axis] * std::round(d[axis] / spec.size[axis]);
      }
      ASSERT_GT(norm(d), r + bodies[b].radius + spec.gap - 1.1e-6 * spec.diameter);
    }
    for (int axis = 0; !spec.periodic && axis < spec.dims; ++axis) {
      ASSERT_GE(bodies[a].centre[axis], 0.999999 * r);
      ASSERT_LE(bodies[a].centre[axis], spec.size[axis] - 0.999999 * r);
    }
  }
  EXPECT_NEAR(1 - grains / volume, spec.porosity, 1e-9);
}

}  // namespace

TEST(Packing, spheres_do_not_overlap_and_leave_the_porosity_asked_for) {
  PackSpec spec;
  spec.size = {1e-3, 0.8e-3, 0.6e-3};
  spec.porosity = 0.5;
  spec.diameter = 1e-4;
  spec.spread = 0.2;
  for (const bool periodic : {true, false}) {
    spec.periodic = periodic;
    expect_apart(spec, make_packing(spec));
  }
}

TEST(Packing, discs_keep_their_gap_and_the_seed_decides) {
  PackSpec spec;
  spec.dims = 2;
  spec.size = {2e-3, 1e-3, 0};
  spec.porosity = 0.5;
  spec.diameter = 8e-5;
  spec.gap = 1.5e-5;
  const auto one = make_packing(spec);
  expect_apart(spec, one);
  EXPECT_EQ(one[3].centre, make_packing(spec)[3].centre);
  spec.seed = 2;
  EXPECT_NE(one[3].centre, make_packing(spec)[3].centre);
}

TEST(Packing, says_when_it_cannot_work) {
  PackSpec spec;
  spec.size = {1, 1, 1};
  spec.diameter = 0.2;
  spec.porosity = 0.1;
  EXPECT_THROW((void)make_packing(spec), InputError);
  spec.porosity = 0.5;
  spec.diameter = 3;
  EXPECT_THROW((void)make_packing(spec), InputError);
}

TEST(Packing, a_written_list_reads_back) {
  PackSpec spec;
  spec.size = {1, 1, 1};
  spec.porosity = 0.7;
  spec.diameter = 0.2;
  const auto bodies = make_packing(spec);
  const auto path = (support::scratch("pack") / "pack.txt").string();
  write_bodies(path, bodies, spec);
  const auto back = read_bodies(path, 3, 1);
  ASSERT_EQ(back.size(), bodies.size());
  EXPECT_NEAR(back[1].centre.z, bodies[1].centre.z, 1e-8);
}

TEST(Micromodel, meets_porosity_grain_size_and_least_throat_and_percolates) {
  for (const bool periodic : {false, true}) {
    MicromodelSpec spec;
    spec.pixels = {700, 500, 1};
    spec.grain = 50;
    spec.throat = 7;
    spec.porosity = 0.45;
    spec.periodic = periodic;
    const Voxels voxels = make_micromodel(spec);
    const Beyond side = periodic ? Beyond::periodic : Beyond::mirror;
    const Metrics m = measure(voxels.view(), 1, {side, side, side}, {});
    EXPECT_NEAR(m.porosity, 0.45, 0.002);
    EXPECT_EQ(m.porosity_connected, m.porosity);
    EXPECT_NEAR(m.grains.mean(), 50, 12);
    EXPECT_GE(m.throat_widths.quantile(0.01), 6.5);  // a pixel image knows widths to half a pixel
    EXPECT_GE(m.throat_widths.quantile(0), 5.5);
    EXPECT_GT(m.throats.size(), 50U);
  }
}

TEST(Micromodel, same_seed_same_picture_other_seed_another) {
  MicromodelSpec spec;
  spec.pixels = {240, 200, 1};
  spec.grain = 30;
  spec.throat = 4;
  const Voxels one = make_micromodel(spec);
  EXPECT_EQ(one.pore, make_micromodel(spec).pore);
  spec.seed = 5;
  EXPECT_NE(one.pore, make_micromodel(spec).pore);
}

TEST(Micromodel, refuses_sizes_that_cannot_work) {
  MicromodelSpec spec;
  spec.pixels = {100, 100, 1};
  spec.grain = 90;
  EXPECT_THROW((void)make_micromodel(spec), InputError);
  spec.grain = 20;
  spec.porosity = 0.05;
  EXPECT_THROW((void)make_micromodel(spec), InputError);
}

}  // namespace porefines::geom
