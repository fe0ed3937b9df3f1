// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "geom/build.hpp"

namespace porefines::geom {

/// A list of grains as an image: pore where the centre of a voxel is; cylinders give one layer.
///
/// @param pixel  [m] wanted edge; along each axis round(size / pixel) voxels fill the box
/// Not collective. Cost: one query of the distance per voxel. Test: unit/domain.
[[nodiscard]] Voxels rasterise(const Sample& sample, Real pixel);

/// The edge of a voxel [m] with which an image of a list has about `voxels` voxels.
[[nodiscard]] Real pixel_for(const Sample& sample, Real voxels);

}  // namespace porefines::geom
