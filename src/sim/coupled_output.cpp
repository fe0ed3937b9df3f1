// SPDX-License-Identifier: MPL-2.0
#include "sim/coupled_output.hpp"

#include <algorithm>

#include "sim/prepare.hpp"
#include "sim/results.hpp"

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
  CoupledSink sink{open_sink(folder, run.particles, provenance, start, coupled_columns()), {}};
  if (config::find_output(run.the_case, config::OutputKind::fields) != nullptr) {
    sink.fields.emplace(open_fields(folder, run.domain, run.solver.block(), provenance, run.comm(),
                                    start, run.time()));
  }
  return sink;
}

void write_coupled(CoupledRun& run, CoupledSink& sink, const std::string& left,
                   std::span<const float> solid) {
  write_due(run.particles, sink.tables, left,
            [&] { return series_values(run, look(run.particles)); });
  if (sink.fields &&
      is_due(run.the_case, config::OutputKind::fields, run.state.fields_written, run.time())) {
    write_fields(*sink.fields, run.time(), cell_fields(run), solid, true);
    ++run.state.fields_written;
  }
}

flow::StokesSolver::CellFields cell_fields(CoupledRun& run) {
  flow::StokesSolver::CellFields fields = run.solver.cell_fields();
  to_case_units(fields, 1, run.offset);
  return fields;
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
