// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "io/provenance.hpp"

namespace porefines::io {

/// An 8-bit picture in memory that belongs to someone else; row 0 is the top.
struct PixelView {
  int width = 0;
  int height = 0;
  int channels = 3;                      ///< 1: grey, 3: red, green, blue interleaved
  std::span<const std::uint8_t> pixels;  ///< width * height * channels, rows without padding
};

/// Writes a PNG under a temporary name, then switches the name (see replace_file).
///
/// The text chunk "Software" holds the provenance line, "Comment" the title when there is one.
/// Call it from one rank.
/// @throws RunError  when sizes do not fit together, or on the system's reason
void write_png(const std::string& path, const PixelView& picture, const Provenance& provenance,
               const std::string& title = {});

}  // namespace porefines::io
