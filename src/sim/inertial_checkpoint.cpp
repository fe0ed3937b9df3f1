// SPDX-License-Identifier: MPL-2.0
#include "sim/inertial_checkpoint.hpp"

#include "config/writer.hpp"
#include "core/error.hpp"
#include "io/checkpoint.hpp"
#include "sim/dry_checkpoint.hpp"

namespace porefines::sim {
namespace {

/// Calls visit(number) for every number of the state, in a fixed order.
template <typename Memory, typename Visit>
void for_memory(Memory& m, const Visit& visit) {
  visit(m.time), visit(m.step), visit(m.before), visit(m.built), visit(m.closing);
}

template <typename State, typename Visit>
void for_reals(State& s, const Visit& visit) {
  visit(s.step), visit(s.courant);
}

template <typename State, typename Visit>
void for_counts(State& s, const Visit& visit) {
  visit(s.steps), visit(s.cycles), visit(s.samples), visit(s.fields_written);
}

}  // namespace

void put_flow(io::Checkpoint& checkpoint, const flow::InertialFlow::Memory& memory,
              const io::GridBlock& grid) {
  std::vector<Real> reals{static_cast<Real>(memory.states)};
  for_memory(memory, [&](Real value) { reals.push_back(value); });
  const bool older = !memory.older.empty();
  reals.push_back(older ? 1 : 0);
  checkpoint.whole("flow_reals", std::move(reals));
  constexpr int columns = flow::InertialFlow::columns;
  checkpoint.block("flow_now", grid, std::span<const Real>(memory.now), columns);
  checkpoint.block("flow_before", grid, std::span<const Real>(memory.old), columns);
  if (older) {
    checkpoint.block("flow_older", grid, std::span<const Real>(memory.older), columns);
  }
}

flow::InertialFlow::Memory get_flow(const io::CheckpointReader& reader, const io::GridBlock& grid) {
  flow::InertialFlow::Memory memory;
  const auto reals = reader.whole<Real>("flow_reals");
  constexpr std::size_t count = 7;
  if (reals.size() != count) {
    throw InputError("the checkpoint is of another version of porefines: start the run anew");
  }
  std::size_t at = 0;
  memory.states = static_cast<int>(reals.at(at++));
  for_memory(memory, [&](Real& value) { value = reals.at(at++); });
  constexpr int columns = flow::InertialFlow::columns;
  memory.now = reader.block<Real>("flow_now", grid, columns);
  memory.old = reader.block<Real>("flow_before", grid, columns);
  if (reals.at(at) != 0) {
    memory.older = reader.block<Real>("flow_older", grid, columns);
  }
  return memory;
}

void write_checkpoint(const InertialRun& run, const std::string& folder,
                      const io::Provenance& provenance) {
  const flow::InertialFlow::Memory memory = run.flow->remember();
  io::Checkpoint checkpoint;
  checkpoint.text("case", config::effective_case(run.the_case));
  std::vector<Real> reals;
  for_reals(run.state, [&](Real value) { reals.push_back(value); });
  checkpoint.whole("inertial_reals", std::move(reals));
  std::vector<std::int64_t> counts;
  for_counts(run.state, [&](Index value) { counts.push_back(value); });
  checkpoint.whole("inertial_counts", std::move(counts));
  put_flow(checkpoint, memory, grid_block(run.domain, run.solver.block()));
  io::write_checkpoint(folder, run.the_case.checkpoint.keep, checkpoint, provenance,
                       run.comm.handle());
}

void go_on(InertialRun& run, const std::string& folder) {
  const io::CheckpointReader reader(folder, run.comm.rank(), run.comm.size());
  require_same_case(reader, run.the_case);
  const auto reals = reader.whole<Real>("inertial_reals");
  std::size_t at = 0;
  for_reals(run.state, [&](Real& value) { value = reals.at(at++); });
  const auto counts = reader.whole<std::int64_t>("inertial_counts");
  at = 0;
  for_counts(run.state, [&](Index& value) { value = counts.at(at++); });
  run.flow->recall(get_flow(reader, grid_block(run.domain, run.solver.block())));
}

}  // namespace porefines::sim
