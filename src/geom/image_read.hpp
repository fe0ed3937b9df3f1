// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "geom/image.hpp"

namespace porefines::geom {

/// Bounds that are checked before memory is taken.
struct ReadLimits {
  Index max_voxels = Index{1} << 36;
};

/// Read a PNG, a TIFF (one page: 2D; several pages: 3D, page = z), a folder of such slices
/// (sorted by name, one slice = z), or a raw volume of one byte per voxel (`.raw`).
///
/// @param raw_size  voxels along x, y, z of a raw volume, stored x fastest, rows downwards
///                  as a camera stores them; ignored otherwise
/// Colour becomes grey by 0.299 R + 0.587 G + 0.114 B; an alpha channel is dropped.
/// Errors: InputError naming the file, what was found and what to try.
/// Tests: unit/geom_image; fuzz/fuzz_image.
[[nodiscard]] GreyVolume read_image(const std::string& path, const Int3& raw_size = {0, 0, 0},
                                    const ReadLimits& limits = {});

/// The same for a PNG or TIFF in memory; `name` is used in messages.
[[nodiscard]] GreyVolume read_image(std::span<const std::uint8_t> bytes, const std::string& name,
                                    const ReadLimits& limits = {});

}  // namespace porefines::geom
