// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

#include <mpi.h>

#include "geom/basins.hpp"
#include "geom/build.hpp"

namespace porefines::geom {

/// A pore: a basin of the distance map, with the largest ball in it.
struct Pore {
  Vec3 centre;      ///< [m] of that ball
  Real radius = 0;  ///< [m]
  Real volume = 0;  ///< [m^3] of the basin
};

/// Pores and the throats between them; the place in a list is the id.
///
/// Ids do not depend on the number of ranks: throats are in order of x, then y, then z, pores in the
/// order of their first voxel. Tests: unit/geom_throats.
struct PoreNetwork {
  std::vector<Pore> pores;
  std::vector<Throat> throats;
  Vec3 size;                       ///< [m] of the sample
  std::array<bool, 3> periodic{};  ///< throats and particles near a face have others beyond it
  bool flat = false;               ///< extruded along z: throats are as deep as the sample
};

/// Of a whole distance field (see whole_solid).
[[nodiscard]] PoreNetwork find_network(const VoxelSolid& solid, const std::array<bool, 3>& periodic,
                                       const ThroatFrame& frame);

/// Of a sample: the image itself; spheres and cylinders are first drawn into voxels of `cell_size`, a
/// 100th to a 200th of the longest edge (cylinders also finer), then their throats are measured on
/// the list itself. Sides that are not periodic are walls: a throat between a grain and a side is as
/// wide as the gap. No pores and throats in an empty box.
/// Not collective: one rank is enough, see share_network. Cost: 512^2 pixels well below 1 s,
/// 200^3 voxels some seconds.
[[nodiscard]] PoreNetwork find_network(const Sample& sample, Real cell_size);

/// Gives the network of rank 0 to all ranks. Collective; `mine` is ignored elsewhere.
[[nodiscard]] PoreNetwork share_network(PoreNetwork mine, MPI_Comm communicator);

/// throats.csv: id,x_m,y_m,z_m,width_m,area_m2, unit vectors across and normal, behind_m,ahead_m
/// (how far it reaches along the normal), pore_behind,pore_ahead.
void write_throats(const std::string& path, const std::vector<Throat>& throats);

/// pores.csv: id,x_m,y_m,z_m,radius_m,volume_m3
void write_pores(const std::string& path, const std::vector<Pore>& pores);

}  // namespace porefines::geom
