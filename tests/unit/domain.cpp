// SPDX-License-Identifier: MPL-2.0
#include "sim/domain.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "sim/plan.hpp"
#include "sim/probe.hpp"

namespace porefines::sim {
namespace {

/// A box with one sphere, driven along x between openings.
struct Subject {
  config::Case the_case;
  geom::Sample sample;

  Subject() {
    the_case.geometry.kind = config::GeometryKind::spheres;
    the_case.geometry.size = {1e-3, 2e-3, 3e-3};
    the_case.grid.cell_size = 1.04e-5;
    the_case.flow.inlet = {BoxFace::x_low, config::DriveKind::pressure, 1};
    the_case.flow.outlet = {BoxFace::x_high, config::DriveKind::pressure, 0};
    the_case.flow.walls = {false, false, true, true, false, false};
    the_case.flow.slip = {false, false, false, false, true, true};
    rebuild();
  }
  void rebuild() {
    sample.spec = geometry_spec(the_case);
    sample.box = {{1e-3, 2e-3, 3e-3}, sample.spec.beyond};
    sample.bodies = {{{0.5e-3, 1e-3, 1.5e-3}, 0.4e-3}};
  }
};

TEST(Domain, cells_meet_the_box_exactly) {
  const Subject s;
  const Domain d = make_domain(s.the_case, s.sample);
  EXPECT_EQ(d.sample_cells(), (Int3{96, 192, 288}));  // round(1 mm / 10.4 um)
  EXPECT_DOUBLE_EQ(d.spacing.x, 1e-3 / 96);
  EXPECT_EQ(d.reservoir, 4) << "at least four cells; 2 % would be two";
  EXPECT_EQ(d.cells[0], 104);
  EXPECT_DOUBLE_EQ(d.origin().x, -4 * d.spacing.x);
  EXPECT_DOUBLE_EQ(d.area(), 6e-6);
}

TEST(Domain, reservoirs_are_as_long_as_asked) {
  Subject s;
  s.the_case.flow.reservoir = 0.25e-3;
  EXPECT_EQ(make_domain(s.the_case, s.sample).reservoir, 24);
  s.the_case.flow.reservoir = 0;
  EXPECT_EQ(make_domain(s.the_case, s.sample).reservoir, 0);
  EXPECT_EQ(geometry_spec(s.the_case).beyond[0], geom::Beyond::mirror);
  s.the_case.flow.reservoir = -1;
  EXPECT_EQ(geometry_spec(s.the_case).beyond[0], geom::Beyond::pore);
  s.the_case.geometry.kind = config::GeometryKind::empty;
  EXPECT_EQ(make_domain(s.the_case, s.sample).reservoir, 0) << "an empty box needs none";
}

TEST(Domain, faces_are_what_the_case_says) {
  Subject s;
  const flow::Boundaries b = make_domain(s.the_case, s.sample).boundaries;
  EXPECT_EQ(b.at(0, false), flow::FaceKind::pressure);
  EXPECT_EQ(b.at(1, true), flow::FaceKind::wall);
  EXPECT_EQ(b.at(2, false), flow::FaceKind::slip);
  s.the_case.flow.inlet->kind = config::DriveKind::velocity;
  EXPECT_EQ(make_domain(s.the_case, s.sample).boundaries.at(0, false), flow::FaceKind::velocity);
  s.the_case.flow.inlet->kind = config::DriveKind::flow_rate;  // solved by a pressure, then scaled
  EXPECT_EQ(make_domain(s.the_case, s.sample).boundaries.at(0, false), flow::FaceKind::pressure);
}

TEST(Domain, refuses_what_cannot_be) {
  Subject s;
  s.the_case.grid.cell_size = 3e-3;
  EXPECT_THROW((void)make_domain(s.the_case, s.sample), InputError);
  s.the_case.grid.cell_size = 1e-12;
  EXPECT_THROW((void)make_domain(s.the_case, s.sample), InputError);
  s.the_case.grid.cell_size = 1e-5;
  s.the_case.flow.outlet->face = BoxFace::y_high;
  EXPECT_THROW((void)make_domain(s.the_case, s.sample), InputError);
}

TEST(Domain, flow_axis_follows_inlet_then_gradient_then_period) {
  config::Flow flow;
  flow.periodic = {false, true, true};
  EXPECT_EQ(flow_axis(flow), 1);
  flow.pressure_gradient = {0, 1, -2};
  EXPECT_EQ(flow_axis(flow), 2);
  flow.inlet = {BoxFace::x_high, config::DriveKind::pressure, 1};
  EXPECT_EQ(flow_axis(flow), 0);
}

/// Sphere of 0.268 mm^3 in 6 mm^3.
TEST(Probe, sees_porosity_work_and_surface) {
  const Subject s;
  const Domain d = make_domain(s.the_case, s.sample);
  const Probe probe = probe_grid(s.sample, d);
  EXPECT_NEAR(probe.porosity, 1 - 0.2681 / 6, 0.003);
  const Real sphere = 4 * 3.14159 * 0.16e-6 / 6e-9;
  EXPECT_NEAR(probe.specific_surface, sphere + probe.porosity * 2 / 2e-3, 0.1 * sphere);
  EXPECT_LT(probe.work[0][52], probe.work[0][5]) << "less fluid through the middle";
  EXPECT_EQ(probe.work[2].size(), 288U);
  EXPECT_GT(probe.work[2][287], 0) << "layers between the ones looked at count too";
}

TEST(Plan, memory_grows_with_cells_and_ranks) {
  const Subject s;
  Domain d = make_domain(s.the_case, s.sample);
  const Probe probe = probe_grid(s.sample, d);
  const auto memory = [&](int ranks) {
    par::LayerWork even;
    for (int a = 0; a < 3; ++a) {
      even[a].assign(static_cast<std::size_t>(d.cells[a]), 1);
    }
    return estimate_memory(s.sample, d, probe, par::decompose(d.cells, ranks, even));
  };
  const Real one = memory(1);
  EXPECT_GT(memory(2), one);
  d.cells[2] *= 2;
  EXPECT_NEAR(memory(1) / one, 2, 0.2);
}

}  // namespace
}  // namespace porefines::sim
