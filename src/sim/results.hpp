// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <span>
#include <string>

#include "config/case.hpp"
#include "core/json.hpp"
#include "flow/stokes.hpp"
#include "geom/build.hpp"
#include "io/fields.hpp"
#include "io/provenance.hpp"
#include "par/communicator.hpp"
#include "par/traffic.hpp"
#include "sim/domain.hpp"
#include "sim/grains.hpp"
#include "sim/plan.hpp"
#include "sim/session.hpp"
#include "sim/steady_flow.hpp"

namespace porefines::sim {

/// What else the summary tells about a run.
struct RunFacts {
  Porosity porosity;
  Index fluid_cells = 0;
  Real wall_time = 0;    ///< [s]
  Real peak_memory = 0;  ///< [bytes] all ranks together
  par::TrafficShares traffic = {};
  Plan plan;
  io::Provenance provenance;
};

/// summary.json: flat, SI, the keys of the interface and a few more; drag only where it has a meaning: round
/// grains in a box with nothing but periodic and slip faces.
[[nodiscard]] Json summarise(const config::Case& the_case, const geom::Sample& sample,
                             const Domain& domain, const SteadyFlow& flow, const RunFacts& facts);

/// Reynolds number of the flow in the pores,
///
///     Re = rho (U / porosity) d / mu,   d = sqrt(32 k / porosity)
[[nodiscard]] Real reynolds(const config::Case& the_case, const SteadyFlow& flow, Real porosity,
                            const Domain& domain);

/// fields.xdmf of a run, x = 0 where the sample begins; or that of an earlier one up to `time` [s].
/// Collective.
[[nodiscard]] io::FieldWriter open_fields(const std::string& folder, const Domain& domain,
                                          const grid::Block& block,
                                          const io::Provenance& provenance,
                                          const par::Communicator& comm, Start start = Start::fresh,
                                          Real time = 0);

/// A step: velocity [m/s], pressure [Pa], solid_fraction of grains; with_fluid: also `fluid`, which is 0
/// in particles too. Collective.
void write_fields(io::FieldWriter& writer, Real time, const flow::StokesSolver::CellFields& fields,
                  std::span<const float> solid, bool with_fluid = false);

}  // namespace porefines::sim
