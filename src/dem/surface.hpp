// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <variant>
#include <vector>

#include "dem/primitive.hpp"
#include "dem/surface_field.hpp"
#include "dem/surface_round.hpp"
#include "dem/touch.hpp"

namespace porefines::dem {

/// What spheres bump into: one description of walls or grains.
using Surface = std::variant<Primitives, RoundGrains<3>, RoundGrains<2>, DistanceField>;

/// All surfaces of a case; a touch's feature carries the place of its surface in the top byte.
using Surfaces = std::vector<Surface>;

inline constexpr int surface_shift = 24;  ///< feature = place in Surfaces << 24 | feature there

/// Adds every touch with gap < reach [m] of a sphere to `out` (which is not cleared).
///
/// Depends on the arguments alone: the same bits on every rank that knows the surface there.
void find_touches(const Surface& surface, const Vec3& centre, Real radius, Real reach,
                  TouchList& out);

/// The same for all surfaces; clears `out` first.
void find_touches(const Surfaces& surfaces, const Vec3& centre, Real radius, Real reach,
                  TouchList& out);

}  // namespace porefines::dem
