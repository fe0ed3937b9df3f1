// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <vector>

#include "config/case.hpp"
#include "flow/stokes.hpp"
#include "geom/build.hpp"
#include "sim/domain.hpp"

namespace porefines::sim {

/// The grains around this rank's block of the grid, ghost layers included. A voxel surface needs
/// no distances: the result is then empty.
[[nodiscard]] geom::Solid local_solid(const config::Case& the_case, const geom::Sample& sample,
                                      const Domain& domain, const par::Decomposition& cut,
                                      int rank);

/// Tells the solver where the grains are: the grid begins a reservoir before the sample.
void link_grains(flow::StokesSolver& solver, const config::Case& the_case,
                 const geom::Sample& sample, const geom::Solid& solid, const Domain& domain);

/// Share of each cell of this rank's block that is grain, x fastest: 1/2 - s/h at the centre,
/// between 0 and 1; second order in the mean.
[[nodiscard]] std::vector<float> solid_fraction(const config::Case& the_case,
                                                const geom::Sample& sample,
                                                const geom::Solid& solid, const Domain& domain,
                                                const grid::Block& block);

/// Porosity of the sample, and of its part that carries flow.
struct Porosity {
  Real total = 1;
  Real connected = 1;
};

/// Images: counted in the voxels, before and after cleaning. Lists: 1 - mean solid fraction; the
/// connected share from an image of at most a million voxels. Collective. Test: cli/drives.
[[nodiscard]] Porosity measure_porosity(const geom::Sample& sample, const Domain& domain,
                                        const grid::Block& block,
                                        const std::vector<float>& solid_fraction,
                                        const par::Communicator& comm);

}  // namespace porefines::sim
