// SPDX-License-Identifier: MPL-2.0
// What runs with a flow do before they solve anything.
#pragma once

#include <string>
#include <vector>

#include "config/case.hpp"
#include "core/progress.hpp"
#include "flow/stokes.hpp"
#include "geom/build.hpp"
#include "io/provenance.hpp"
#include "par/communicator.hpp"
#include "sim/domain.hpp"
#include "sim/plan.hpp"
#include "sim/results.hpp"
#include "sim/run.hpp"
#include "sim/steady_flow.hpp"

namespace porefines::sim {

/// What is known before anything is solved.
struct Prepared {
  geom::Sample sample;
  Domain domain;
  Plan plan;
  par::Decomposition cut;
  std::vector<std::string> story;  ///< for a person
};

/// Geometry, grid, cost. Collective.
/// @throws InputError  also when the machine cannot hold it
[[nodiscard]] Prepared prepare(const config::Case& the_case, const par::Communicator& comm);

/// --dry-run: the numbers, also as plan.json, and a picture of the geometry. Collective.
void show_plan(const config::Case& the_case, const RunOptions& options, const Prepared& prepared,
               const io::Provenance& provenance, const par::Communicator& comm);

/// Links fluid and grains; returns the share of solid in every cell. Collective.
[[nodiscard]] std::vector<float> set_up(flow::StokesSolver& solver, const config::Case& the_case,
                                        const Prepared& prepared, const par::Communicator& comm);

/// What the summary tells besides the flow, but for the cost so far. Collective.
/// @param solid  share of each cell that is grain
[[nodiscard]] RunFacts facts_of(const Prepared& prepared, const flow::StokesSolver& solver,
                                const std::vector<float>& solid, const io::Provenance& provenance,
                                const par::Communicator& comm);
/// Wall time and peak memory of all ranks so far. Collective.
void take_cost(RunFacts& facts, const Stopwatch& watch, const par::Communicator& comm);

/// The fields of a solver as those of the case: see SteadyFlow::scale and offset. Collective.
[[nodiscard]] flow::StokesSolver::CellFields case_fields(flow::StokesSolver& solver, Real scale,
                                                         Real offset);

}  // namespace porefines::sim
