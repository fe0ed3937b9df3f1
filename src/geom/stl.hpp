// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "geom/contours.hpp"
#include "geom/voxel_solid.hpp"

namespace porefines::geom {

/// A triangle in single precision [m], counter-clockwise seen from the pore.
using Triangle = std::array<std::array<float, 3>, 3>;

/// Grains extruded from z = 0 to z = depth, with caps: a closed surface.
[[nodiscard]] std::vector<Triangle> extrude(const std::vector<Outline>& outlines, Real depth);

/// Surface s = 0 of a 3D solid by marching tetrahedra (six per cube), closed at the box faces.
///
/// Watertight by construction: every edge belongs to exactly two triangles.
/// Needs a solid whose window is the whole image. About 8 triangles per surface voxel.
/// Ref: Payne & Toga, IEEE Comput. Graph. Appl. 10 (1990) 33-41.
[[nodiscard]] std::vector<Triangle> grain_surface(const VoxelSolid& solid);

/// Binary STL: 80 bytes of title, count, 50 bytes per triangle. Lengths in m.
/// Throws RunError when the file cannot be written.
void write_stl(const std::string& path, const std::vector<Triangle>& triangles);

/// Volume enclosed by a closed surface [m^3], by the divergence theorem.
[[nodiscard]] Real enclosed_volume(const std::vector<Triangle>& triangles);

}  // namespace porefines::geom
