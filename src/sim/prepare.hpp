// SPDX-License-Identifier: MPL-2.0
// What runs with a flow do before they solve anything.
#pragma once

#include <string>
#include <vector>

#include "config/case.hpp"
#include "flow/stokes.hpp"
#include "geom/build.hpp"
#include "io/provenance.hpp"
#include "par/communicator.hpp"
#include "sim/domain.hpp"
#include "sim/plan.hpp"
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

/// --dry-run: the numbers and a picture of the geometry. Collective.
void show_plan(const config::Case& the_case, const RunOptions& options, const Prepared& prepared,
               const io::Provenance& provenance, const par::Communicator& comm);

/// Links fluid and grains; returns the share of solid in every cell. Collective.
[[nodiscard]] std::vector<float> set_up(flow::StokesSolver& solver, const config::Case& the_case,
                                        const Prepared& prepared, const par::Communicator& comm);

/// Fields as the solver holds them -> those of the case: see SteadyFlow::scale and offset.
void to_case_units(flow::StokesSolver::CellFields& fields, Real scale, Real offset);

}  // namespace porefines::sim
