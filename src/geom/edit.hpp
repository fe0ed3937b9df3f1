// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include "geom/image.hpp"
#include "geom/voxels.hpp"

namespace porefines::geom {

/// Let every grain recede by `depth` [voxels] all around: what imaging or etching made too fat.
///
///     grain -> pore   where the next pore voxel's centre is nearer than depth + 1/2
///
/// so that a depth of 1 takes one layer, and less than 1/2 nothing. Reservoirs do not erode.
/// @return voxels opened. Test: unit/geom_edit.
Index erode_grains(Voxels& voxels, Real depth, const Surroundings& beyond);

/// Open the voxels that are white (255) in the mask and close the black ones (0); any other grey leaves
/// them as they are.
/// @return voxels changed
/// Errors: InputError when the sizes differ, when no voxel or every voxel of the mask is black or white.
/// Test: unit/geom_edit.
Index apply_edit_mask(Voxels& voxels, const GreyVolume& mask, const std::string& name);

}  // namespace porefines::geom
