// SPDX-License-Identifier: MPL-2.0
#include "sim/coupled_readings.hpp"

#include <cmath>

#include "analysis/gather_sample.hpp"
#include "sim/particle_setup.hpp"
#include "sim/particle_walls.hpp"

namespace porefines::sim {
namespace {

/// What a fine touches, of all that is nearest. In a chip the plates carry no arch: a fine that also
/// touches a grain leans on that.
analysis::WallTouch wall_of(const dem::Settings& settings, const Vec3& x, Real radius, Real reach,
                            bool flat) {
  dem::TouchList touches;
  dem::find_touches(settings.walls, x, radius, reach, touches);
  analysis::WallTouch nearest{INFINITY, {}};
  Real rank = INFINITY;
  for (const dem::Touch& touch : touches.view()) {
    const bool plate = flat && std::abs(touch.normal.z) > 0.9;
    const Real order = touch.gap + (plate ? 2 * radius : 0);
    if (order < rank) {
      rank = order;
      nearest = {touch.gap, touch.normal};
    }
  }
  return nearest;
}

analysis::RestRules rest_rules(const CoupledRun& run) {
  const config::Clogging& asked = run.the_case.clogging;
  const Real speed =
      std::abs(run.state.clean_rate) * run.domain.length() / std::max(run.pore_volume, 1e-300);
  analysis::RestRules rules = analysis::default_rest_rules(2 * largest_radius(run.the_case), speed);
  rules.stop_share = asked.stop_share;
  rules.hold_time = asked.hold_time > 0 ? asked.hold_time : rules.hold_time;
  rules.release_travel = asked.release_travel;
  rules.contact_gap = asked.contact_gap;
  return rules;
}

/// Volume fraction of the one injection whose concentration is given; 0: as measured.
Real asked_concentration(const CoupledRun& run) {
  const std::vector<config::Injection>& asked = run.the_case.injection;
  if (asked.size() != 1 || asked[0].kind == config::Concentration::rate) {
    return 0;
  }
  constexpr Real unit_flow = 1;
  return injected_volume(run.the_case, asked[0], run.particles.inlets[0].density, unit_flow);
}

std::vector<analysis::ThroatPressure> pressures_at(const CoupledRun& run, const Readings& readings,
                                                   const flow::StokesSolver::CellFields& fields) {
  const Domain& domain = run.domain;
  const analysis::CellReader pressure{fields.pressure, fields.fluid, &run.solver.block(),
                                      domain.spacing, domain.origin()};
  return analysis::read_throats(readings.probes, pressure, run.comm(),
                                (-run.state.drive_factor) * run.drive.force);
}

analysis::OwnedSample sample_of(const CoupledRun& run, bool flat) {
  const dem::System& system = run.particles.system;
  const dem::Particles& p = system.particles();
  analysis::OwnedSample mine;
  for (std::size_t i = 0; i < p.owned; ++i) {
    const Real reach = run.the_case.clogging.contact_gap * 2 * p.radius[i];
    mine.put(p.id[i], p.position[i], p.velocity[i], p.radius[i],
             wall_of(system.settings(), p.position[i], p.radius[i], reach, flat));
  }
  mine.scalars.time = run.time();
  mine.scalars.pore_volumes = run.pore_volumes();
  mine.scalars.fluid_speed =
      std::abs(run.now.darcy.flow_rate) * run.domain.length() / run.pore_volume;
  mine.scalars.out = run.particles.state.ledger.out;
  return mine;
}

}  // namespace

Readings open_readings(const std::string& folder, const CoupledRun& run, const geom::Sample& sample,
                       std::span<const float> solid, Start start) {
  const Domain& domain = run.domain;
  const config::Clogging& asked = run.the_case.clogging;
  Readings readings;
  analysis::ReadingSetup& setup = readings.setup;
  geom::PoreNetwork found;
  on_root(run.comm(), [&] { found = geom::find_network(sample, domain.spacing.x); });
  setup.network = geom::share_network(std::move(found), run.comm().handle());
  setup.bins = {domain.axis, 0, domain.length(), asked.profile_bins};
  setup.pore_volumes =
      analysis::pore_volumes_along(solid, run.solver.block(), domain.spacing,
                                   domain.origin()[domain.axis], setup.bins, run.comm());
  setup.area = domain.area();
  setup.rest = rest_rules(run);
  setup.blocks.reach = asked.reach;
  setup.blocks.sieve_share = asked.sieve_share;
  setup.c0 = asked_concentration(run);
  const dem::Settings& settings = run.particles.system.settings();
  readings.probes = analysis::place_probes(
      setup.network, [&](const Vec3& x) { return in_wall(settings, x) ? -1.0 : 1.0; },
      domain.spacing.x);
  on_root(run.comm(), [&] {
    readings.tables.emplace(folder, setup.network,
                            start == Start::resumed ? std::optional(run.time()) : std::nullopt);
  });
  return readings;
}

std::vector<Real> take_readings(CoupledRun& run, Readings& readings, const MomentFields& fields) {
  const analysis::OwnedSample all =
      analysis::gather_sample(sample_of(run, readings.setup.network.flat), run.comm());
  const std::vector<analysis::ThroatPressure> pressures = pressures_at(run, readings, fields());
  const analysis::Throughput throughput{run.state.fluid_passed, run.state.volume_in,
                                        run.state.volume_out};
  std::vector<Real> row;
  on_root(run.comm(), [&] {
    row = analysis::reading_row(analysis::take_reading(
        run.state.readings, readings.setup, all.view(), throughput, pressures, &*readings.tables));
    readings.ids = all.id;
  });
  const auto clogged = static_cast<Real>(run.state.readings.clogging.clogs.size());
  run.state.clogged_throats = static_cast<Index>(run.comm().max(clogged));  // rank 0 knows
  return row;
}

}  // namespace porefines::sim
