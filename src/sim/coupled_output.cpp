// SPDX-License-Identifier: MPL-2.0
#include "sim/coupled_output.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "sim/dry_results.hpp"
#include "sim/pictures.hpp"
#include "sim/results.hpp"

namespace porefines::sim {
namespace {

/// A row of series.csv. Concentrations stand among the first columns, other readings come last.
std::vector<Real> series_values(CoupledRun& run, Readings& readings, const MomentFields& fields) {
  const Moment moment = look(run.particles);
  std::vector<Real> read = take_readings(run, readings, fields);
  read.resize(analysis::reading_columns().size());  // only rank 0 has them
  const Ledger& ledger = run.particles.state.ledger;
  std::vector<Real> row{run.time(),
                        run.pore_volumes(),
                        run.permeability_ratio(),
                        run.now.darcy.flow_rate,
                        run.now.darcy.pressure_drop,
                        read[0],
                        read[1],
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
  row.insert(row.end(), read.begin() + 2, read.end());
  return row;
}

}  // namespace

std::vector<std::string> coupled_columns() {
  const std::vector<std::string> read = analysis::reading_columns();
  std::vector<std::string> columns{"time_s",
                                   "pore_volumes",
                                   "permeability_ratio",
                                   "flow_rate_m3_s",
                                   "pressure_drop_pa",
                                   read[0],
                                   read[1],
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
  columns.insert(columns.end(), read.begin() + 2, read.end());
  return columns;
}

CoupledSink open_coupled_sink(const std::string& folder, const CoupledRun& run,
                              const geom::Sample& sample, std::span<const float> solid,
                              const io::Provenance& provenance, Start start) {
  CoupledSink sink{open_sink(folder, run.particles, provenance, start, coupled_columns()),
                   {},
                   open_readings(folder, run, sample, solid, start)};
  if (config::find_output(run.the_case, config::OutputKind::fields) != nullptr) {
    sink.fields.emplace(open_fields(folder, run.domain, run.solver.block(), provenance, run.comm(),
                                    start, run.time()));
  }
  return sink;
}

void write_coupled(CoupledRun& run, CoupledSink& sink, const std::string& left,
                   const RunCanvas& canvas, std::span<const float> solid) {
  const MomentFields fields = fields_of_moment(run);
  const View view{[&] { return series_values(run, sink.readings, fields); },
                  [&] {
                    return paint_run(run, canvas, sink.readings, fields, solid,
                                     report::FineColour::fate);
                  }};
  write_due(run.particles, sink.tables, left, view);
  if (falls_due(run.particles, config::OutputKind::fields)) {
    write_fields(*sink.fields, run.time(), fields(), solid, true);
  }
}

void write_end(CoupledRun& run, CoupledSink& sink, const RunCanvas& canvas,
               const geom::Sample& sample, std::span<const float> solid) {
  const MomentFields fields = fields_of_moment(run);
  const std::string& folder = sink.tables.folder;
  const io::Provenance& provenance = sink.tables.provenance;
  finish_movie(run.particles, sink.tables);
  if (sink.fields && !is_sampled(run.the_case, config::OutputKind::fields)) {
    write_fields(*sink.fields, run.time(), fields(), solid, true);
  }
  if (config::find_output(run.the_case, config::OutputKind::pictures) == nullptr) {
    return;
  }
  using enum report::FineColour;
  for (const auto& [name, colour] : {std::pair{"particles", fate}, {"particles_speed", speed}}) {
    write_moment(fmt::format("{}/{}.png", folder, name), run.particles,
                 paint_run(run, canvas, sink.readings, fields, solid, colour), provenance);
  }
  draw_fields(folder, run.the_case, sample, run.domain, fields(), solid, run.solver.block(),
              provenance, run.comm());
}

void add_coupled(Json& json, const CoupledRun& run) {
  const Moment moment = look(run.particles);
  const Ledger& ledger = run.particles.state.ledger;
  const CoupledState& s = run.state;
  json.set("time_s", run.time());
  json.set("permeability_clean_m2", s.clean_permeability);
  json.set("permeability_m2", run.now.darcy.permeability);
  json.set("permeability_darcy", run.now.darcy.permeability / darcy);
  json.set("permeability_ratio", run.permeability_ratio());
  json.set("flow_rate_m3_s", run.now.darcy.flow_rate);
  json.set("pressure_drop_pa", run.now.darcy.pressure_drop);
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
  const analysis::FateCounts& counts = s.readings.clogging.counts;
  json.set("piping_share", counts.share(counts.piping));
  json.set("bridging_share", counts.share(counts.bridging));
  json.set("clogged_share", counts.share(counts.clogged));
  json.set("resting_share", counts.share(counts.resting));
  json.set("clogged_throats", static_cast<Index>(s.readings.clogging.clogs.size()));
}

}  // namespace porefines::sim
