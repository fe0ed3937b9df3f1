// SPDX-License-Identifier: MPL-2.0
#include "sim/results.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analysis/drag.hpp"
#include "analysis/permeability.hpp"
#include "io/fields.hpp"

namespace porefines::sim {
namespace {

/// Nothing but grains takes up force.
bool only_grains_hold(const Domain& domain) {
  const auto free = [](flow::FaceKind kind) {
    return kind == flow::FaceKind::periodic || kind == flow::FaceKind::slip;
  };
  return std::all_of(domain.boundaries.kind.begin(), domain.boundaries.kind.end(), free);
}

bool equal_sizes(const std::vector<geom::Body>& bodies) {
  return std::all_of(bodies.begin(), bodies.end(), [&](const geom::Body& body) {
    return std::abs(body.radius / bodies.front().radius - 1) < 1e-6;
  });
}

void add_drag(Json& json, const config::Case& the_case, const geom::Sample& sample,
              const Domain& domain, const SteadyFlow& flow) {
  if (sample.bodies.empty() || !only_grains_hold(domain)) {
    return;
  }
  const Real gradient = flow.pressure_drop / domain.length();
  const Vec3 size = domain.size();
  const Real drag = analysis::mean_drag(gradient, size.x * size.y * size.z,
                                        static_cast<Index>(sample.bodies.size()));
  json.set("bodies", sample.bodies.size());
  json.set("drag_n", drag);
  if (!equal_sizes(sample.bodies)) {
    return;
  }
  const Real mu = the_case.fluid.viscosity;
  const Real u = flow.velocity[domain.axis];
  if (sample.spec.kind == geom::Kind::spheres) {
    json.set("drag_coefficient_mean",
             analysis::sphere_drag_factor(drag, mu, sample.bodies.front().radius, u));
  } else {
    json.set("drag_per_length_over_viscosity_velocity",
             analysis::cylinder_drag_factor(drag, mu, size.z, u));
  }
}

void add_tensor(Json& json, const SteadyFlow& flow, const config::Flow& asked) {
  constexpr std::string_view names = "xyz";
  for (int i = 0; flow.tensor && i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (asked.periodic[j]) {
        json.set(fmt::format("k_{}{}", names[i], names[j]), (*flow.tensor)[j][i]);
      }
    }
  }
}

}  // namespace

Real reynolds(const config::Case& the_case, const SteadyFlow& flow, Real porosity,
              const Domain& domain) {
  const Real speed = std::abs(flow.flow_rate) / domain.area() / porosity;
  return the_case.fluid.density * speed *
         analysis::equivalent_pore_diameter(std::abs(flow.permeability), porosity) /
         the_case.fluid.viscosity;
}

Json summarise(const config::Case& the_case, const geom::Sample& sample, const Domain& domain,
               const SteadyFlow& flow, const RunFacts& facts) {
  const bool pushed_by_openings = the_case.flow.inlet.has_value();
  Json json;
  json.set("status", "done");
  json.set("title", the_case.run.title);
  json.set("porosity", facts.porosity.total);
  json.set("porosity_connected", facts.porosity.connected);
  json.set("permeability_m2", flow.permeability);
  json.set("permeability_darcy", flow.permeability / darcy);
  add_tensor(json, flow, the_case.flow);
  json.set("darcy_velocity_m_s", flow.flow_rate / domain.area());
  json.set("pressure_drop_pa", flow.pressure_drop);
  if (pushed_by_openings) {
    json.set("pressure_drop_with_reservoirs_pa", flow.total_drop);
  }
  json.set("flow_rate_m3_s", flow.flow_rate);
  json.set("flux_variation", flow.flux_variation);
  json.set("reynolds", reynolds(the_case, flow, facts.porosity.connected, domain));
  add_drag(json, the_case, sample, domain, flow);
  json.set("fluid_density_kg_m3", the_case.fluid.density);
  json.set("fluid_viscosity_pa_s", the_case.fluid.viscosity);
  json.set("length_m", domain.length());
  json.set("area_m2", domain.area());
  json.set("cell_size_m", domain.spacing.x);
  json.set("solver_cycles", flow.solve.cycles);
  json.set("flux_cycles", flow.solve.flux_cycles);
  json.set("solver_residual", flow.solve.residual);
  json.set("cells", product(domain.cells));
  json.set("cells_x", domain.cells[0]);
  json.set("cells_y", domain.cells[1]);
  json.set("cells_z", domain.cells[2]);
  json.set("fluid_cells", facts.fluid_cells);
  json.set("ranks", facts.provenance.ranks);
  json.set("wall_time_s", facts.wall_time);
  json.set("time_halo_s", facts.traffic.halo);
  json.set("time_reductions_s", facts.traffic.reductions);
  json.set("time_waiting_s", facts.traffic.waiting);
  json.set("messages_per_rank", facts.traffic.messages);
  json.set("message_bytes_per_rank", facts.traffic.bytes);
  json.set("collectives_per_rank", facts.traffic.collectives);
  json.set("peak_memory_bytes", static_cast<Index>(facts.peak_memory));
  json.set("planned_memory_bytes", static_cast<Index>(facts.plan.memory));
  json.set("planned_memory_most_bytes", static_cast<Index>(facts.plan.memory_most));
  for (const auto& [name, value] : io::entries(facts.provenance)) {
    if (name != "ranks") {
      json.set(name, value);
    }
  }
  return json;
}

io::FieldWriter open_fields(const std::string& folder, const Domain& domain,
                            const grid::Block& block, const io::Provenance& provenance,
                            const par::Communicator& comm, Start start, Real time) {
  const io::GridBlock grid = grid_block(domain, block);
  return start == Start::resumed
             ? io::FieldWriter::resume(folder, comm.handle(), grid, provenance, time)
             : io::FieldWriter(folder, comm.handle(), grid, provenance);
}

void write_fields(io::FieldWriter& writer, Real time, const flow::StokesSolver::CellFields& fields,
                  std::span<const float> solid, bool with_fluid) {
  std::vector<float> velocity(3 * fields.pressure.size());
  for (std::size_t at = 0; at < fields.pressure.size(); ++at) {
    for (std::size_t c = 0; c < 3; ++c) {
      velocity[3 * at + c] = fields.velocity[c][at];
    }
  }
  std::vector<io::ScalarField> scalars{{"pressure", fields.pressure}, {"solid_fraction", solid}};
  if (with_fluid) {
    scalars.push_back({"fluid", fields.fluid});
  }
  const std::array<io::VectorField, 1> vectors{io::VectorField{"velocity", velocity}};
  writer.write(time, scalars, vectors);
}

}  // namespace porefines::sim
