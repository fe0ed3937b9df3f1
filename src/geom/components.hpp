// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/types.hpp"
#include "geom/voxels.hpp"

namespace porefines::geom {

enum class Phase { grain, pore };

/// A connected part of one phase.
struct Component {
  Index voxels = 0;
  bool touches_low = false;   ///< the low face of the axis asked about
  bool touches_high = false;  ///< the high face
  bool wraps = false;         ///< through the periodic faces of that axis back to itself
};

/// Voxels of one phase as runs along x, each with its component.
struct Components {
  struct Run {
    int first;  ///< x of the first voxel
    int past;
    std::int32_t component;
  };
  std::vector<std::size_t> row;  ///< per row j + n[1] k: where its runs start; one more at the end
  std::vector<Run> run;
  std::vector<Component> component;
};

/// Connected components by union-find over runs.
///
/// Pores connect through faces (6 in 3D, 4 in 2D), grains through faces, edges and corners
/// (26, 8): the usual dual pair, so that a grain wall of one voxel separates two pores.
/// @param periodic  axes along which opposite faces are neighbours
/// @param axis      the axis of touches_low, touches_high and wraps
/// Memory follows the number of runs, not of voxels. Test: unit/geom_components.
[[nodiscard]] Components find_components(const VoxelView& voxels, Phase phase,
                                         const std::array<bool, 3>& periodic, int axis);

/// Whether a component carries flow along the axis: from face to face, or around the period.
[[nodiscard]] inline bool percolates(const Component& component, bool periodic) {
  return periodic ? component.wraps : component.touches_low && component.touches_high;
}

}  // namespace porefines::geom
