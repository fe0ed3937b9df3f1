// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include "geom/voxels.hpp"

namespace porefines::geom {

/// Write a binary volume as an image, 255 = pore, 0 = grain: .png (2D) or .tif/.tiff (2D, or 3D as
/// pages = z). read_image() gives the same volume back.
/// Errors: InputError for another ending or a 3D volume as PNG; RunError when writing fails.
void write_image(const std::string& path, const VoxelView& voxels);

}  // namespace porefines::geom
