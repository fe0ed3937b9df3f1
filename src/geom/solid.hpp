// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <variant>

#include "core/types.hpp"
#include "geom/round_bodies.hpp"
#include "geom/voxel_solid.hpp"

namespace porefines::geom {

/// No grains at all.
struct Empty {
  Real band = 1;  ///< [m] the distance returned everywhere
};

/// The grains of a sample, ready for distance queries.
using Solid = std::variant<Empty, SphereList, CylinderList, VoxelSolid>;

/// Distance to the grain surface at x [m], positive in the pore.
///
/// The origin is the low corner of the sample box. True up to the band that the solid was built
/// with; saturates at +-band beyond, with the right sign. Lists are exact; images to about 0.1
/// pixel (see VoxelSolid). Cost O(1).
[[nodiscard]] Real signed_distance(const Solid& solid, const Vec3& x);

/// Band of validity of signed_distance [m].
[[nodiscard]] Real band_of(const Solid& solid);

/// Unit normal grad s / |grad s| into the pore, by central differences over +-step [m];
/// zero where s is constant (beyond the band).
[[nodiscard]] Vec3 normal(const Solid& solid, const Vec3& x, Real step);

}  // namespace porefines::geom
