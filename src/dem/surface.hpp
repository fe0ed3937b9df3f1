// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "dem/mesh.hpp"
#include "dem/primitive.hpp"
#include "dem/surface_field.hpp"
#include "dem/surface_round.hpp"
#include "dem/touch.hpp"

namespace porefines::dem {

/// Grains that never change: copies share them.
template <class Grains>
struct Fixed {
  std::shared_ptr<const Grains> grains;

  explicit Fixed(Grains given) : grains(std::make_shared<const Grains>(std::move(given))) {}
};

template <class Grains>
void find_touches(const Fixed<Grains>& fixed, const Vec3& centre, Real radius, Real reach,
                  TouchList& out) {
  find_touches(*fixed.grains, centre, radius, reach, out);
}

/// What spheres bump into: one description of walls or grains.
using Surface = std::variant<Primitives, Fixed<RoundGrains<3>>, Fixed<RoundGrains<2>>,
                             Fixed<DistanceField>, Fixed<Mesh>>;

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
