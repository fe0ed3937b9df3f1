// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/types.hpp"

namespace porefines::geom {

/// Grey levels 0..255 of an image or an image stack, x fastest, y upwards, z = page.
///
/// Picture row r (counted from the top) is y index ny-1-r, so that pictures of the simulation
/// look the way the user's image looks. A 2D image has n[2] = 1.
/// 16-bit images are kept when their values fit in 8 bits (labels); else they are scaled so that
/// the full scale (10, 12, 14 or 16 bits, the smallest that holds the maximum) becomes 255.
struct GreyVolume {
  Int3 n{0, 0, 0};
  std::vector<std::uint8_t> grey;
};

}  // namespace porefines::geom
