// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "dem/touch.hpp"
#include "geom/round_bodies.hpp"

namespace porefines::dem {

/// Spheres (dims = 3) or cylinders along z (dims = 2) as grains: exact, one touch per grain.
///
/// The feature of a touch is the grain's place in its list, on either side of a periodic face.
/// Touches with cylinders' ends do not exist: a chip's top and bottom are walls of their own.
template <int dims>
struct RoundGrains {
  geom::RoundBodies<dims> bodies;  ///< their band must be radius + reach of the largest sphere
  Vec3 corner;                     ///< [m] of the sample's box in the coordinates of the particles
};

/// Touches with gap < reach; `uncovered` when radius + reach exceeds the band of the list.
/// Test: unit/dem_surface_round.
template <int dims>
void find_touches(const RoundGrains<dims>& grains, const Vec3& centre, Real radius, Real reach,
                  TouchList& out) {
  const Real within = radius + reach;
  out.uncovered = out.uncovered || within > 1.000001 * grains.bodies.band();
  grains.bodies.for_each_near(centre - grains.corner, within,
                              [&](const Vec3& d, Real grain, std::int32_t which) {
                                const Real away = norm(d);
                                const Vec3 normal = away > 0 ? d / away : Vec3{1, 0, 0};
                                out.inside = out.inside || away <= grain;
                                out.add({normal,
                                         away - grain - radius,
                                         {},
                                         0.5 * (dims - 1) / grain,
                                         1,
                                         static_cast<std::uint32_t>(which)});
                              });
}

}  // namespace porefines::dem
