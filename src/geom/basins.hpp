// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/types.hpp"
#include "geom/components.hpp"
#include "geom/voxel_solid.hpp"

namespace porefines::geom {

/// When two maxima of the distance are one body: the lower peak p stands less than
/// max(absolute, relative p) above the pass between them.
struct Merging {
  float relative = 0.15F;
  float absolute = 0.8F;  ///< [pixels]
};

/// Pores or grains told apart where they are narrowest.
struct Basins {
  std::vector<std::int32_t> label;  ///< per voxel: number of its basin, -1 in the other phase
  std::vector<Index> voxels;        ///< per basin
  std::vector<float> peak;          ///< per basin: largest distance [pixels]
};

/// Watershed of the distance map with merging of shallow maxima.
///
/// Voxels are taken in order of falling distance; one without a labelled neighbour starts a
/// basin, the others join their deepest neighbour, and two basins that meet merge by the rule
/// above (persistence of maxima; the aim is that of Gostick, Phys. Rev. E 96 (2017) 023307).
/// Pores: distances are those of the ridge (ridge_gain), else slanted channels fall apart.
/// Neighbours: all 26 (8) for pores and in 2D, 6 for grains in 3D.
/// @param solid  window = whole image, band above the largest distance
[[nodiscard]] Basins find_basins(const VoxelSolid& solid, Phase phase,
                                 const std::array<bool, 3>& periodic, const Merging& merging = {});

/// A constriction between two pores.
struct Throat {
  Vec3 centre;     ///< [m]
  Vec3 across;     ///< unit vector along the shortest chord
  Real width = 0;  ///< [m] length of that chord, at least half a pixel
  Vec3 from;       ///< [m] its ends on the grain surface
  Vec3 to;
};

/// Throats: on each connected patch where two pore basins meet, the voxel of largest distance;
/// its width is the shortest chord through it from wall to wall.
[[nodiscard]] std::vector<Throat> find_throats(const VoxelSolid& solid, const Basins& pores,
                                               const std::array<bool, 3>& periodic);

}  // namespace porefines::geom
