// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "config/case.hpp"
#include "flow/boundary.hpp"
#include "geom/build.hpp"
#include "grid/block.hpp"
#include "io/fields.hpp"

namespace porefines::sim {

/// The axis along which the permeability is measured: of the inlet, else of the largest pressure
/// gradient, else the first periodic one.
[[nodiscard]] int flow_axis(const config::Flow& flow);

/// The face that the fluid flows to: the outlet, unless the pressures say otherwise.
[[nodiscard]] BoxFace flow_to(const config::Flow& flow);

/// What the geometry module has to know of a case.
/// Beyond the sample: periodic axes repeat it, reservoirs are open pore, walls mirror it.
[[nodiscard]] geom::Spec geometry_spec(const config::Case& the_case);

/// Where the grid lies: the sample's box, and reservoirs of open fluid before and after it.
struct Domain {
  Int3 cells{1, 1, 1};  ///< of the whole grid
  Vec3 spacing;         ///< [m] cell edges; they meet the sample's box exactly
  Vec3 sample_size;     ///< [m]
  int axis = 0;         ///< of the flow
  int reservoir = 0;    ///< cells before the sample, and as many after it
  flow::Boundaries boundaries;

  /// [m] corner of the grid relative to the sample's: minus the reservoir.
  [[nodiscard]] Vec3 origin() const;
  [[nodiscard]] Vec3 size() const;    ///< [m] of the whole grid
  [[nodiscard]] Real length() const;  ///< [m] of the sample along the flow
  [[nodiscard]] Real area() const;    ///< [m^2] cross-section, grains included
  [[nodiscard]] Int3 sample_cells() const;
};

/// Grid and boundaries of a case.
///
///     cells = round(length / cell_size),   spacing = length / cells
///
/// Automatic reservoirs have max(4 cells, 2 % of the sample); none when there are no grains.
/// @throws InputError  a cell larger than the box, voxels that are not cells, openings that are not
///                     opposite, a 2D image without depth
/// Tests: unit/domain.
[[nodiscard]] Domain make_domain(const config::Case& the_case, const geom::Sample& sample);

/// Where a block lies in the sample's coordinates, for files.
[[nodiscard]] io::GridBlock grid_block(const Domain& domain, const grid::Block& block);

}  // namespace porefines::sim
