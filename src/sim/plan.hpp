// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

#include "config/case.hpp"
#include "par/communicator.hpp"
#include "sim/domain.hpp"
#include "sim/probe.hpp"

namespace porefines::sim {

/// What a run will cost and what to expect of it, before it is run.
struct Plan {
  Real memory = 0;         ///< [bytes] peak of all ranks together
  Real memory_most = 0;    ///< [bytes] the same where cycles gain little and directions are kept
  Real seconds = 0;        ///< wall time, about; 0: not estimated
  Real cycle_seconds = 0;  ///< of one cycle of the solve
  Real permeability = 0;   ///< [m^2] Kozeny's guess
  Real velocity = 0;       ///< [m/s] Darcy velocity that follows
  Real reynolds = 0;       ///< of that velocity in the pores
  Index cells = 0;
  Index active_cells = 0;  ///< in lines of 16 that hold any fluid
};

/// Bytes of a search direction per active cell: u, v, w, p of z and of q, in float.
inline constexpr Real direction_bytes = 2 * 4 * sizeof(float);

/// Peak memory of all ranks together [bytes].
///
///     ranks base + voxel voxels + max(set-up + distance voxels, levels + packed active cells)
///
/// `levels` counts the fields of all multigrid levels of every rank, ghosts and padding too; `packed`
/// the Krylov vectors, which leave out lines of solid. Test: cli/permeability, mpi.
/// @param cut  the ranks' blocks
[[nodiscard]] Real estimate_memory(const geom::Sample& sample, const Domain& domain,
                                   const Probe& probe, const par::Decomposition& cut);

/// The whole plan. Permeability by Kozeny, k = porosity^3 / (5 S^2): a guess, within a factor of 6 so far (Berea: 5.8 times too high).
[[nodiscard]] Plan make_plan(const config::Case& the_case, const geom::Sample& sample,
                             const Domain& domain, const Probe& probe,
                             const par::Decomposition& cut);

/// Sets the wall time of the flow solve and of a cycle [s]: bytes to move at the rate of this machine, which a short sweep over
/// memory on all ranks at once finds out. Fitted on a loaded machine: an order of size. Collective, a tenth of a second.
void estimate_seconds(const config::Case& the_case, Plan& plan, const par::Communicator& comm);

/// Refuses what this machine cannot hold, and says which size it can. Collective.
/// @throws InputError  on every rank
void require_memory(const config::Case& the_case, const Plan& plan, const Domain& domain,
                    const par::Communicator& comm);

/// The plan in lines for a person.
[[nodiscard]] std::vector<std::string> describe(const config::Case& the_case,
                                                const geom::Sample& sample, const Domain& domain,
                                                const Probe& probe, const Plan& plan);

}  // namespace porefines::sim
