// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <cstdint>

namespace porefines::geom {

/// The 3x3x3 neighbourhood of a voxel, 1 = pore, index (dx+1) + 3 (dy+1) + 9 (dz+1).
using Neighbourhood = std::array<std::uint8_t, 27>;

/// Whether changing the phase of the centre leaves the topology as it is.
///
/// Pores connect through faces (6 in 3D, 4 in 2D), grains also through edges and corners (26, 8).
/// The centre is simple when its grain neighbours form one 26-component and its pore neighbours,
/// seen through faces within the 18-neighbourhood, form one component that touches the centre
/// (Bertrand & Malandain, Pattern Recognit. Lett. 15 (1994) 169-175).
/// In 2D the planes dz = -1 and dz = +1 are ignored.
/// Test: unit/geom_simple_point.
[[nodiscard]] bool is_simple(const Neighbourhood& around, bool flat);

}  // namespace porefines::geom
