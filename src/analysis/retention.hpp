// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/run_sample.hpp"
#include "grid/block.hpp"
#include "par/communicator.hpp"

namespace porefines::analysis {

/// Equal bins along the flow.
struct ProfileBins {
  int axis = 0;
  Real low = 0;   ///< [m]
  Real high = 1;  ///< [m]
  int count = 50;

  [[nodiscard]] Real width() const { return (high - low) / count; }
  [[nodiscard]] Real centre(int bin) const { return low + (bin + 0.5) * width(); }
};

/// Pore volume in every bin without particles [m^3]; collective, the same on every rank.
///
/// Cells that lie across a bin's edge are shared out by length.
/// @param solid    solid fraction of the block's own cells, x fastest
/// @param spacing  [m] cell edges
/// @param origin   [m] where the grid's first cell begins, along the bins' axis
[[nodiscard]] std::vector<Real> pore_volumes_along(std::span<const float> solid,
                                                   const grid::Block& block, const Vec3& spacing,
                                                   Real origin, const ProfileBins& bins,
                                                   const par::Communicator& comm);

/// Particles per bin.
struct RetentionProfile {
  std::vector<Index> retained;         ///< by the place of their centres
  std::vector<Real> retained_volume;   ///< [m^3] spheres cut at the bins' edges
  std::vector<Real> suspended_volume;  ///< [m^3] of those that move
};

/// @param fates  of the sample's particles: all but `piping` are retained
/// Cost O(particles + bins). Test: unit/run_readings (a sphere across an edge; sums are kept).
[[nodiscard]] RetentionProfile retention_along(const RunSample& sample, std::span<const Fate> fates,
                                               const ProfileBins& bins);

/// Volume of a sphere below a plane at `height` from its centre [m^3]: pi (r + h)^2 (2 r - h) / 3.
[[nodiscard]] Real sphere_below(Real radius, Real height);

/// retention.csv: one row per bin and sample.
///
/// x_m; retained: their number; retained_per_m3: per pore volume; retained_fraction and
/// suspended_fraction: their volume per pore volume; porosity_clean and porosity: without and with
/// the retained ones as solid.
[[nodiscard]] std::vector<std::string> retention_columns();

/// @param pore_volumes  as pore_volumes_along gives them
/// @param area          [m^2] cross-section, grains included
[[nodiscard]] std::string retention_rows(const RunSample& sample, const RetentionProfile& profile,
                                         std::span<const Real> pore_volumes, Real area,
                                         const ProfileBins& bins);

}  // namespace porefines::analysis
