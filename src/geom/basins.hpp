// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
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

/// A constriction between two pores, seen as a short channel along its normal.
struct Throat {
  Vec3 centre;     ///< [m] middle of the shortest chord
  Vec3 across;     ///< unit vector along the shortest chord, normal to `normal`
  Real width = 0;  ///< [m] length of that chord, at least half a pixel
  Vec3 from = {};  ///< [m] its ends on the grain surface
  Vec3 to = {};
  Vec3 normal = {};  ///< unit vector through the throat, along +axis of the flow where it is not 0
  Real area = 0;     ///< [m^2] of the section normal to it; 2D: width times depth
  Real behind = 0;   ///< [m] how far against the normal the gap stays below 5/4 width
  Real ahead = 0;    ///< [m] and along it
  std::int32_t pore_behind = -1;  ///< basins that it joins
  std::int32_t pore_ahead = -1;
};

/// How throats lie in their sample.
struct ThroatFrame {
  int flow_axis = 0;
  Real depth = 0;               ///< [m] of a 2D image; 0: one pixel
  std::array<bool, 3> walls{};  ///< axes whose faces end a throat instead of mirroring it
  /// [m] to the grains where it is known better than from the voxels, as for lists
  std::function<Real(const Vec3&)> distance = {};
};

/// Throats: on each connected patch where two pore basins meet, the voxel of largest distance;
/// its width is the shortest chord through it from wall to wall. In order of x, then y, then z.
[[nodiscard]] std::vector<Throat> find_throats(const VoxelSolid& solid, const Basins& pores,
                                               const std::array<bool, 3>& periodic,
                                               const ThroatFrame& frame = {});

}  // namespace porefines::geom
