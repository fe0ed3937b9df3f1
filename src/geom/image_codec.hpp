// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geom/image.hpp"
#include "geom/image_read.hpp"

namespace porefines::geom {

/// Samples of an image before they are reduced to 8 bits; rows downwards as in the file.
struct Samples {
  Int3 n{0, 0, 0};
  std::vector<std::uint16_t> wide;   ///< 16-bit images; empty otherwise
  std::vector<std::uint8_t> narrow;  ///< 8-bit images; empty otherwise
};

/// Throws InputError when nx * ny * nz is zero or beyond the limits.
void require_reasonable_size(const std::string& name, Index nx, Index ny, Index nz,
                             const ReadLimits& limits);

/// To 8 bits (rule of GreyVolume) and to y upwards.
[[nodiscard]] GreyVolume to_grey(Samples samples);

[[nodiscard]] Samples read_tiff_file(const std::string& path, const ReadLimits& limits);
[[nodiscard]] Samples read_tiff(std::span<const std::uint8_t> bytes, const std::string& name,
                                const ReadLimits& limits);
[[nodiscard]] Samples read_png(std::span<const std::uint8_t> bytes, const std::string& name,
                               const ReadLimits& limits);

[[nodiscard]] bool looks_like_tiff(std::span<const std::uint8_t> bytes);
[[nodiscard]] bool looks_like_png(std::span<const std::uint8_t> bytes);

}  // namespace porefines::geom
