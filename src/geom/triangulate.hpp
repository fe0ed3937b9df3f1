// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geom/contours.hpp"

namespace porefines::geom {

/// Corner of a triangulation: point `place` of outline `outline`.
struct Corner {
  std::int32_t outline;
  std::int32_t place;
};

/// Triangles that fill the area enclosed by outlines with holes (counter-clockwise).
///
/// Each hole is joined to the outline that surrounds it by a bridge, then ears are clipped. Every
/// outline segment belongs to exactly one triangle and every inner edge to two, whatever the
/// rounding: meshes built on it are closed. Cost: about (points of one polygon)^2.
[[nodiscard]] std::vector<std::array<Corner, 3>> triangulate(const std::vector<Outline>& outlines);

}  // namespace porefines::geom
