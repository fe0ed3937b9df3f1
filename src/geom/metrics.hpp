// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

#include "core/json.hpp"
#include "geom/basins.hpp"

namespace porefines::geom {

/// A weighted sample of sizes [m], sorted by size.
struct SizeDistribution {
  std::vector<Real> size;
  std::vector<Real> weight;

  void sort();
  [[nodiscard]] bool empty() const { return size.empty(); }
  [[nodiscard]] Real mean() const;
  /// Size below which `share` of the weight lies.
  [[nodiscard]] Real quantile(Real share) const;
};

/// What is asked about a sample besides its geometry.
struct Question {
  Real fine_diameter = 0;  ///< [m] for o/d and D/d; 0: not asked
  Real cell_size = 0;      ///< [m] of the flow grid; 0: the pixel size
  Real depth = 0;          ///< [m] of a 2D image; 0: one pixel
  Real smooth = 1;         ///< [pixels] standard deviation of the smoothing
  int flow_axis = 0;
};

/// Geometry of a sample in numbers.
struct Metrics {
  Int3 voxels{};
  Real pixel = 0;               ///< [m]
  Real porosity = 0;            ///< of the voxels
  Real porosity_connected = 0;  ///< of those that carry flow along the axis
  Real porosity_smooth = 0;     ///< under the smooth surface
  Real specific_surface = 0;    ///< [1/m] grain surface / bulk volume (side walls not counted)
  SizeDistribution pores;       ///< local pore diameter, weighted by volume
  SizeDistribution grains;      ///< equivalent diameter of each grain, by number
  std::vector<Throat> throats;
  SizeDistribution throat_widths;  ///< by number
  Real throats_under_4_cells = 0;  ///< share; the flow in them is off by more than 3 %
  SmoothingReport smoothing;
};

/// Measure a cleaned volume. Cost: 512^2 pixels well below 1 s, 200^3 voxels a few seconds.
///
/// Grains cut by the box faces count with what is inside; the equivalent diameter of area A or
/// volume V is sqrt(4 A/pi) or cbrt(6 V/pi).
[[nodiscard]] Metrics measure(const VoxelView& image, Real pixel, const Surroundings& beyond,
                              const Question& question);

/// metrics.json: flat, SI, names with units.
[[nodiscard]] Json to_json(const Metrics& metrics, const Question& question);

}  // namespace porefines::geom
