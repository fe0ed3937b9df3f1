// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <vector>

#include "core/types.hpp"
#include "geom/voxel_solid.hpp"

namespace porefines::geom {

using Point2 = std::array<Real, 2>;  ///< [m] x, y

/// A closed polyline, the last point joined to the first. Grain lies to its left: outer outlines
/// run counter-clockwise, holes clockwise.
using Outline = std::vector<Point2>;

/// Outlines of the grains of a 2D solid: the line s = 0 by marching squares on the voxel centres.
///
/// Grains are closed along the box faces: everything outside the box counts as pore.
/// Needs a solid whose window is the whole image. Diagonal neighbours in one square are parted
/// (grains touch at corners only through their voxels, as in Components of the pore).
[[nodiscard]] std::vector<Outline> grain_outlines(const VoxelSolid& solid);

/// Douglas-Peucker simplification of closed outlines.
///
/// Every dropped point lies within `tolerance` [m] of the new outline; outlines that would keep
/// fewer than three points are kept as the triangle of three far apart points.
[[nodiscard]] std::vector<Outline> simplify(const std::vector<Outline>& outlines, Real tolerance);

/// Area [m^2], positive for counter-clockwise outlines.
[[nodiscard]] Real signed_area(const Outline& outline);

}  // namespace porefines::geom
