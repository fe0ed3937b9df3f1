// SPDX-License-Identifier: MPL-2.0
#include "sim/coupled_output.hpp"

#include <cmath>

#include <fmt/format.h>

#include "sim/dry_results.hpp"
#include "sim/results.hpp"
#include "sim/session.hpp"
#include "sim/tracks.hpp"

namespace porefines::sim {
namespace {

/// Volume of particles in the fluid that entered, and in what left, since the last row.
std::vector<Real> series_values(CoupledRun& run, const Moment& moment) {
  CoupledState& s = run.state;
  const Ledger& ledger = run.particles.state.ledger;
  const Real passed = s.fluid_passed - s.sampled_fluid;
  const auto share = [&](Real particles) { return passed > 0 ? particles / passed : 0; };
  std::vector<Real> row{run.time(),
                        run.pore_volumes(),
                        run.permeability_ratio(),
                        run.now.flow_rate,
                        run.now.pressure_drop,
                        share(s.volume_in - s.sampled_in),
                        share(s.volume_out - s.sampled_out),
                        static_cast<Real>(moment.totals.particles),
                        moment.mean_speed,
                        moment.sigma.x,
                        moment.sigma.y,
                        moment.sigma.z,
                        moment.mean.x,
                        moment.mean.y,
                        moment.mean.z,
                        static_cast<Real>(ledger.placed + ledger.injected),
                        static_cast<Real>(ledger.out),
                        static_cast<Real>(moment.totals.contacts),
                        static_cast<Real>(moment.totals.wall_contacts),
                        moment.max_overlap,
                        run.particles.state.step,
                        static_cast<Real>(run.now.cycles)};
  s.sampled_fluid = s.fluid_passed;
  s.sampled_in = s.volume_in;
  s.sampled_out = s.volume_out;
  return row;
}

void write_step_fields(CoupledRun& run, CoupledSink& sink, std::span<const float> solid) {
  flow::StokesSolver::CellFields fields = run.solver.cell_fields();
  const auto pressure = static_cast<float>(run.offset);
  for (std::size_t at = 0; at < fields.pressure.size(); ++at) {
    fields.pressure[at] += fields.fluid[at] != 0 ? pressure : 0.0F;
  }
  std::vector<float> velocity(3 * fields.pressure.size());
  for (std::size_t at = 0; at < fields.pressure.size(); ++at) {
    for (std::size_t a = 0; a < 3; ++a) {
      velocity[3 * at + a] = fields.velocity[a][at];
    }
  }
  const std::vector<io::ScalarField> scalars{
      {"pressure", fields.pressure}, {"solid_fraction", solid}, {"fluid", fields.fluid}};
  const std::vector<io::VectorField> vectors{{"velocity", velocity}};
  sink.fields->write(run.time(), scalars, vectors);
}

}  // namespace

std::vector<std::string> coupled_columns() {
  return {"time_s",
          "pore_volumes",
          "permeability_ratio",
          "flow_rate_m3_s",
          "pressure_drop_pa",
          "inlet_concentration",
          "outlet_concentration",
          "particles_inside",
          "mean_speed_m_s",
          "sigma_x_m",
          "sigma_y_m",
          "sigma_z_m",
          "mean_x_m",
          "mean_y_m",
          "mean_z_m",
          "particles_injected",
          "particles_out",
          "contacts",
          "wall_contacts",
          "max_overlap",
          "time_step_s",
          "solver_cycles"};
}

CoupledSink open_coupled_sink(const std::string& folder, const CoupledRun& run,
                              const io::Provenance& provenance, Start start) {
  CoupledSink sink{folder, provenance, {}, {}, {}};
  on_root(run.comm(), [&] {
    const Real time = run.time();
    sink.series.emplace(open_table(folder + "/series.csv", coupled_columns(), time, start));
    if (const auto* output = config::find_output(run.the_case, config::OutputKind::tracks)) {
      sink.tracks.emplace(
          open_table(folder + "/tracks.csv", track_columns(output->forces), time, start));
    }
  });
  if (config::find_output(run.the_case, config::OutputKind::fields) != nullptr) {
    const grid::Block& b = run.solver.block();
    const io::GridBlock grid{b.global, run.domain.origin(), run.domain.spacing, b.start, b.n};
    if (start == Start::resumed) {
      sink.fields.emplace(
          io::FieldWriter::resume(folder, run.comm().handle(), grid, provenance, run.time()));
    } else {
      sink.fields.emplace(folder, run.comm().handle(), grid, provenance);
    }
  }
  return sink;
}

void write_coupled(CoupledRun& run, CoupledSink& sink, const std::string& left,
                   std::span<const float> solid) {
  DryState& state = run.particles.state;
  std::string rows = left;
  if (is_due(run.the_case, config::OutputKind::tracks, state.tracked, run.time())) {
    rows += track_rows(run.particles);
    ++state.tracked;
  }
  std::vector<Real> row;
  if (is_due(run.the_case, config::OutputKind::summary, state.samples, run.time())) {
    row = series_values(run, look(run.particles));
    ++state.samples;
  }
  on_root(run.comm(), [&] {
    if (sink.tracks && !rows.empty()) {
      sink.tracks->append_lines(rows);
    }
    if (!row.empty()) {
      sink.series->append(row);
    }
  });
  if (sink.fields &&
      is_due(run.the_case, config::OutputKind::fields, run.state.fields_written, run.time())) {
    write_step_fields(run, sink, solid);
    ++run.state.fields_written;
  }
  if (is_due(run.the_case, config::OutputKind::pictures, state.drawn, run.time())) {
    draw_dry(fmt::format("{}/particles_{:05}.png", sink.folder, state.drawn), run.particles,
             sink.provenance);
    ++state.drawn;
  }
}

void add_coupled(Json& json, const CoupledRun& run) {
  const Moment moment = look(run.particles);
  const Ledger& ledger = run.particles.state.ledger;
  const CoupledState& s = run.state;
  json.set("time_s", run.time());
  json.set("permeability_clean_m2", s.clean_permeability);
  json.set("permeability_m2", run.now.permeability);
  json.set("permeability_darcy", run.now.permeability / darcy);
  json.set("permeability_ratio", run.permeability_ratio());
  json.set("flow_rate_m3_s", run.now.flow_rate);
  json.set("pressure_drop_pa", run.now.pressure_drop);
  json.set("pore_volumes_injected", run.pore_volumes());
  json.set("particles_placed", ledger.placed);
  json.set("particles_injected", ledger.injected);
  json.set("particles_inside", moment.totals.particles);
  json.set("particles_out", ledger.out);
  const auto entered = static_cast<Real>(std::max<Index>(ledger.placed + ledger.injected, 1));
  json.set("inside_fraction", static_cast<Real>(moment.totals.particles) / entered);
  json.set("mean_speed_m_s", moment.mean_speed);
  json.set("sigma_x_m", moment.sigma.x);
  json.set("sigma_y_m", moment.sigma.y);
  json.set("sigma_z_m", moment.sigma.z);
  json.set("contacts", moment.totals.contacts);
  json.set("wall_contacts", moment.totals.wall_contacts);
  json.set("max_overlap", moment.max_overlap);
  json.set("steps", run.particles.state.steps);
  json.set("solves", s.solves);
  json.set("cycles_per_solve",
           static_cast<Real>(s.cycles) / static_cast<Real>(std::max<Index>(s.solves, 1)));
  json.set("contact_substeps", s.substeps);
}

}  // namespace porefines::sim
