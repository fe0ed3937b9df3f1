// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <mpi.h>

#include "core/types.hpp"
#include "geom/segment.hpp"
#include "geom/share.hpp"
#include "geom/solid.hpp"

namespace porefines::geom {

enum class Kind { image, spheres, cylinders, empty };

/// Where the grains are and how they are prepared; mirrors [geometry] of a case. Lengths in m.
struct Spec {
  Kind kind = Kind::image;
  std::string source;          ///< path of the image or list
  Real pixel_size = 0;         ///< [m] image
  Segmentation segmentation;   ///< image
  Int3 raw_size{0, 0, 0};      ///< raw volumes
  std::array<Int3, 2> crop{};  ///< {first, past last} voxel, y upwards; zeros: everything
  Real depth = 0;              ///< [m] extrusion of a 2D image along z; 0: one pixel
  Vec3 size;                   ///< [m] box of spheres, cylinders, empty
  Real list_unit = 1;          ///< [m]
  bool periodic_images = true;
  Real smooth = -1;              ///< [m] standard deviation of the smoothing; negative: one pixel
  bool only_percolating = true;  ///< fill pores that do not connect the faces of flow_axis
  int remove_grains_below = 0;   ///< [voxels]
  int fill_pores_below = 0;      ///< [voxels]
  Real erode_grains = 0;         ///< [m] grains recede by this much
  std::string edit_mask;         ///< path of an image that opens or closes voxels
  Real minimum_throat = 0;       ///< [m] narrower throats are opened to this width
  int reconnect_gap = 0;  ///< [voxels] walls up to this thickness between separate pores open
  Surroundings beyond{Beyond::mirror, Beyond::mirror, Beyond::mirror};
  int flow_axis = 0;  ///< along which pores must percolate
};

/// The sample as understood: cleaned voxels or a list of bodies, the same on every rank.
struct Sample {
  Spec spec;
  SampleBox box;             ///< [m]
  Real pixel = 0;            ///< [m] image
  SharedVoxels voxels;       ///< image
  std::vector<Body> bodies;  ///< lists
  Index found_pores = 0;     ///< pore voxels before cleaning
  Index kept_pores = 0;      ///< and after
};

/// Read, segment, crop and clean on rank 0; the result goes to all ranks. Collective.
/// Errors: InputError on every rank.
[[nodiscard]] Sample build_sample(const Spec& spec, MPI_Comm communicator);

/// Distance field for the points of the box {low, high} [m] (a rank's block, ghost layers
/// included), true up to `band` [m]. Not collective; for lists every rank holds all bodies.
/// For images the band is at least four pixels.
[[nodiscard]] Solid make_solid(const Sample& sample, const Vec3& low, const Vec3& high, Real band);

}  // namespace porefines::geom
