// SPDX-License-Identifier: MPL-2.0
#include "sim/coupled_checkpoint.hpp"

#include <array>

#include "io/checkpoint.hpp"
#include "par/gather.hpp"
#include "sim/coupled_inertia.hpp"
#include "sim/dry_checkpoint.hpp"
#include "sim/inertial_checkpoint.hpp"
#include "sim/pictures.hpp"

namespace porefines::sim {
namespace {

/// Calls visit(number) for every real number of the state, in a fixed order.
template <typename State, typename Visit>
void for_reals(State& s, const Visit& visit) {
  visit(s.stiffness), visit(s.deepest), visit(s.drive_factor), visit(s.fluid_passed),
      visit(s.volume_in), visit(s.volume_out);
}

template <typename Now, typename Visit>
void for_flow(Now& now, const Visit& visit) {
  visit(now.darcy.flow_rate), visit(now.darcy.pressure_drop), visit(now.darcy.permeability),
      visit(now.residual);
}

template <typename State, typename Visit>
void for_counts(State& s, const Visit& visit) {
  visit(s.solves), visit(s.cycles), visit(s.substeps), visit(s.stiffened);
  visit(s.clogged_throats);
}

constexpr int sphere_columns = 17;

std::array<Real, sphere_columns> numbers_of(const flow::Sphere& q) {
  return {q.position.x, q.position.y, q.position.z, q.radius,   q.held ? 1.0 : 0.0, q.velocity.x,
          q.velocity.y, q.velocity.z, q.spin.x,     q.spin.y,   q.spin.z,           q.force.x,
          q.force.y,    q.force.z,    q.torque.x,   q.torque.y, q.torque.z};
}

flow::Sphere sphere_of(std::uint64_t id, const Real* n) {
  return {id,
          {n[0], n[1], n[2]},
          n[3],
          n[4] != 0,
          {n[5], n[6], n[7]},
          {n[8], n[9], n[10]},
          {n[11], n[12], n[13]},
          {n[14], n[15], n[16]}};
}

/// The memory must live until the checkpoint is written.
void put_creeping_flow(io::Checkpoint& checkpoint, const flow::StokesSolver::Memory& memory) {
  checkpoint.whole("flow_scale", std::vector<Real>{memory.scale});
  checkpoint.rows("flow_unknowns", std::span<const Real>(memory.unknowns));
  std::vector<std::uint64_t> ids;
  std::vector<Real> numbers;
  for (const flow::Sphere& q : memory.spheres) {
    ids.push_back(q.id);
    const auto row = numbers_of(q);
    numbers.insert(numbers.end(), row.begin(), row.end());
  }
  checkpoint.rows("flow_sphere_ids", std::move(ids));
  checkpoint.rows("flow_spheres", std::move(numbers), sphere_columns);
}

}  // namespace

void write_checkpoint(const CoupledRun& run, const std::string& folder,
                      const io::Provenance& provenance) {
  const dem::Snapshot snapshot = run.particles.system.save();
  flow::InertialFlow::Memory inertial;
  io::Checkpoint checkpoint;
  put_run(checkpoint, run.particles, snapshot);
  std::vector<Real> reals;
  for_reals(run.state, [&](Real value) { reals.push_back(value); });
  for_flow(run.now, [&](Real value) { reals.push_back(value); });
  checkpoint.whole("coupled_reals", std::move(reals));
  std::vector<std::int64_t> counts;
  for_counts(run.state, [&](Index value) { counts.push_back(value); });
  checkpoint.whole("coupled_counts", std::move(counts));
  std::vector<Real> readings = analysis::pack(run.state.readings);
  par::broadcast(run.comm(), readings);
  checkpoint.whole("readings", std::move(readings));
  const flow::StokesSolver::Memory memory =
      run.inertial ? flow::StokesSolver::Memory{} : run.solver.remember();
  if (run.inertial) {
    inertial = run.inertial->remember();
    put_flow(checkpoint, inertial, grid_block(run.domain, run.solver.block()));
  } else {
    put_creeping_flow(checkpoint, memory);
  }
  io::write_checkpoint(folder, run.the_case.checkpoint.keep, checkpoint, provenance,
                       run.comm().handle());
}

void go_on(CoupledRun& run, const std::string& folder) {
  const io::CheckpointReader reader(folder, run.comm().rank(), run.comm().size());
  get_run(reader, run.particles);
  const auto reals = reader.whole<Real>("coupled_reals");
  const auto counts = reader.whole<std::int64_t>("coupled_counts");
  std::size_t at = 0;
  const Real softened = run.state.stiffness;
  for_reals(run.state, [&](Real& value) { value = reals.at(at++); });
  run.particles.system.soften(run.state.stiffness / softened);
  for_flow(run.now, [&](Real& value) { value = reals.at(at++); });
  at = 0;
  for_counts(run.state, [&](Index& value) { value = counts.at(at++); });
  run.state.readings = analysis::unpack_readings(reader.whole<Real>("readings"));
  if (run.inertial) {
    recall_inertia(run, get_flow(reader, grid_block(run.domain, run.solver.block())));
    return;
  }
  if (!reader.same_ranks()) {
    return;  // the flow is solved anew
  }
  flow::StokesSolver::Memory memory;
  memory.scale = reader.whole<Real>("flow_scale").at(0);
  memory.unknowns = reader.rows<Real>("flow_unknowns");
  const auto ids = reader.rows<std::uint64_t>("flow_sphere_ids");
  const auto numbers = reader.rows<Real>("flow_spheres", sphere_columns);
  for (std::size_t q = 0; q < ids.size(); ++q) {
    memory.spheres.push_back(sphere_of(ids[q], &numbers[q * sphere_columns]));
  }
  run.solver.recall(memory);
  run.cold = false;
  feed_inlets(run);
}

}  // namespace porefines::sim
