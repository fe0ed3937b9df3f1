// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <span>
#include <string>

#include "config/case.hpp"
#include "flow/stokes.hpp"
#include "geom/build.hpp"
#include "io/provenance.hpp"
#include "par/communicator.hpp"
#include "report/picture.hpp"
#include "sim/domain.hpp"

namespace porefines::sim {

/// The plane of cells in the middle of the grid normal to `axis`, on rank 0; empty elsewhere.
///
/// @param values, solid  this rank's block, x fastest; solid: share of a cell that is grain
/// @param origin         [m] low corner of the grid
/// Collective: one reduction of a plane.
[[nodiscard]] report::SliceValues gather_mid_slice(std::span<const float> values,
                                                   std::span<const float> solid,
                                                   const grid::Block& block, const Domain& domain,
                                                   int axis, const par::Communicator& comm);

/// |u| in every cell.
[[nodiscard]] std::vector<float> speeds_of(const flow::StokesSolver::CellFields& fields);

/// The mean along an axis, on rank 0; empty elsewhere. Collective.
[[nodiscard]] report::SliceValues gather_mean_slice(std::span<const float> values,
                                                    const grid::Block& block, const Domain& domain,
                                                    int axis, const par::Communicator& comm);

/// Is one plane enough? Extruded images, cylinders, and boxes that are thin along z.
[[nodiscard]] bool is_chip(const geom::Sample& sample, const Domain& domain);

/// speed.png and pressure.png: the middle plane of a chip, three planes of a volume. Collective.
void draw_fields(const std::string& folder, const config::Case& the_case,
                 const geom::Sample& sample, const Domain& domain,
                 const flow::StokesSolver::CellFields& fields, std::span<const float> solid,
                 const grid::Block& block, const io::Provenance& provenance,
                 const par::Communicator& comm);

/// geometry.png: distance to the nearest grain on the same planes. Not collective: one rank.
void draw_sample(const std::string& folder, const config::Case& the_case,
                 const geom::Sample& sample, const Domain& domain,
                 const io::Provenance& provenance);

}  // namespace porefines::sim
