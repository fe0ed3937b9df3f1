// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dem/surface.hpp"

namespace porefines::dem {

/// Where spheres are to be packed. Faces of the region that are not periodic are walls.
struct PackingSpace {
  Vec3 low;   ///< [m]
  Vec3 high;  ///< [m]
  std::array<bool, 3> periodic{};
  const Surfaces* surfaces = nullptr;  ///< further walls, grains
  std::uint64_t seed = 1;

  [[nodiscard]] Real volume() const {
    const Vec3 edge = high - low;
    return edge.x * edge.y * edge.z;
  }
};

/// Spheres at rest.
struct Packing {
  std::vector<Vec3> position;  ///< [m]
  std::vector<Real> radius;    ///< [m]
  Real scale = 1;              ///< of the radii asked for, see pack_dense
  Real mean_overlap = 0;       ///< of the contacts, over the mean diameter of each pair
  Real contacts = 0;           ///< per sphere, all spheres counted
  Index steps = 0;             ///< of the minimiser, all together
};

/// Spheres of these radii at random places without touching: random points, pushed apart by
/// minimising the energy of their overlaps.
///
/// @throws InputError  when they do not fit (random spheres do up to a share of 0.6)
[[nodiscard]] Packing place_loose(const PackingSpace& space, const std::vector<Real>& radius);

/// Random close packing at rest, frictionless: random points are quenched to the nearest minimum of
///
///     E = sum (k/2) overlap^2
///
/// at a density above jamming; then all radii shrink step by step, each time at rest again, until
/// the overlaps all but vanish ("point J" from above). The radii keep their ratios, their scale
/// follows: spheres fill the space as it is.
///
/// Minimiser: FIRE (Bitzek et al. 2006). Protocol: O'Hern, Silbert, Liu & Nagel 2003, who find a
/// volume fraction of 0.639 +- 0.003. Mean overlap at the end: below 5e-4 of a diameter.
/// Not collective: every rank finds the same. Cost: seconds for 10,000 spheres.
/// Tests: unit/dem_packing, validation/packing.
[[nodiscard]] Packing pack_dense(const PackingSpace& space, std::vector<Real> radius);

/// Random close packing of spheres; how many fill a space follows from it.
inline constexpr Real close_packing = 0.639;

/// [m^3] of the spheres.
[[nodiscard]] Real sphere_volume(const std::vector<Real>& radius);
[[nodiscard]] Real sphere_volume(Real radius);

}  // namespace porefines::dem
