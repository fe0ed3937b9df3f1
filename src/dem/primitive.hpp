// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <span>
#include <variant>
#include <vector>

#include "dem/touch.hpp"

namespace porefines::dem {

/// Rigid motion of a wall: v(x) = velocity + spin x (x - about).
struct Motion {
  Vec3 velocity;  ///< [m/s]
  Vec3 spin;      ///< [rad/s]
  Vec3 about;     ///< [m] moves along
};

/// Half space behind a plane.
struct Plane {
  Vec3 point;
  Vec3 normal;  ///< unit, into the space of the particles
  Motion motion{};
};

/// Cylinder of infinite length; the particles are around it, or inside (a tube).
struct Cylinder {
  Vec3 point;  ///< on the axis
  Vec3 axis;   ///< unit
  Real radius = 0;
  bool hollow = false;
  Motion motion{};
};

/// Sphere; the particles are around it, or inside.
struct Ball {
  Vec3 centre;
  Real radius = 0;
  bool hollow = false;
  Motion motion{};
};

using Primitive = std::variant<Plane, Cylinder, Ball>;

/// Walls of simple shape; the feature of a touch is the place in the list.
using Primitives = std::vector<Primitive>;

/// Check sizes, give normals and axes unit length.
/// Errors: InputError for a radius that is not positive or a direction of no length.
[[nodiscard]] Primitives checked(Primitives walls);

/// Faces of the box {low, high} as planes that look inward; order of BoxFace.
[[nodiscard]] Primitives box_faces(const Vec3& low, const Vec3& high,
                                   const std::array<bool, 6>& which);

/// Walls move for `dt` [s]: points translate, normals and axes turn (to second order in spin dt).
void advance(Primitives& walls, Real dt);

/// Where the walls are, 9 numbers each, for a checkpoint.
[[nodiscard]] std::vector<Real> places(const Primitives& walls);
/// Puts the walls back there. @return what is left of the numbers
std::span<const Real> put_back(Primitives& walls, std::span<const Real> places);

/// Touches with gap < reach. Exact; O(number of walls).
///
/// In a hollow shape that the sphere does not fit (radius > that of the shape) the whole rim
/// touches: one touch at the nearest side, marked `inside`.
/// Test: unit/dem_primitive.
void find_touches(const Primitives& walls, const Vec3& centre, Real radius, Real reach,
                  TouchList& out);

}  // namespace porefines::dem
