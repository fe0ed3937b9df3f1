// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <vector>

#include "geom/voxel_solid.hpp"

namespace porefines::geom {

/// Distance field of a whole image with a band above the largest pore radius, in 2D also above
/// the largest grain radius (at most 400 pixels; 29 in the grains of a 3D image): starts with
/// 14.5 pixels and doubles. Open faces are taken as mirrors.
[[nodiscard]] VoxelSolid whole_solid(const VoxelView& image, Real pixel, Surroundings beyond,
                                     Real sigma);

/// How much higher the ridge of s may run between the voxel centres [pixels, 0..1/2]: along one
/// axis a ridge of unit slopes has the second difference D = -2 when a centre lies on it (gain 0)
/// and -1 when it runs midway between two centres (gain 1/2); flat profiles (D = 0) gain nothing.
[[nodiscard]] float ridge_gain(const VoxelSolid& solid, Index v);

/// Pore size at every voxel: diameter of the largest ball inside the pore that holds it,
///
///     T(x) = 2 max { s(c) : |x - c| < s(c) + 1/2 },
///
/// [pixels], 0 in grains (Hildebrand & Ruegsegger, J. Microsc. 185 (1997) 67-75). Only balls
/// that no neighbour's ball contains are drawn; their radii are corrected for ridges of s that
/// run between voxel centres. Balls are cut at the box faces.
[[nodiscard]] std::vector<float> local_thickness(const VoxelSolid& solid);

/// Area of the smooth surface [m^2] (length times `depth` for a 2D image):
///
///     S = sum delta(s) |grad s| V,   delta(s) = (1 + cos(pi s / e)) / (2 e), e = 1.5 pixels
///
/// (co-area formula): a pixel staircase would overstate it by up to 4/pi in 2D and 3/2 in 3D.
[[nodiscard]] Real surface_area(const VoxelSolid& solid, Real depth);

}  // namespace porefines::geom
