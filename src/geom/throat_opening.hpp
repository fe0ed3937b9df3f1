// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "geom/voxels.hpp"

namespace porefines::geom {

/// Widen every throat narrower than `width` [voxels] to that width by eroding grains locally.
///
/// 1. Core: the pore voxels where a ball of diameter `width` fits.
/// 2. Thin the rest of the pore, the lowest distance first, by removing simple points: what
///    remains beside the core are the centre lines of the links between core parts (and of loops
///    and of ways to the box faces); cusps between touching grains leave nothing.
/// 3. Open a ball of diameter `width` around every voxel of these lines.
/// Repeated while new links appear, at most three times.
///
/// Links closed in the image (walls between pores) stay closed: see reconnect().
/// @return voxels opened
/// Widths of the result are at least `width` and at most one voxel more (2D; measured along x or
/// y); in 3D they may fall short by one voxel. Test: unit/geom_throat_opening.
Index open_throats(Voxels& voxels, Real width, const Surroundings& beyond);

}  // namespace porefines::geom
