// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <functional>
#include <span>

#include "dem/surface_spline.hpp"

namespace porefines::dem {

/// Point of a surface where the distance to a centre has a local minimum.
struct Foot {
  Vec3 at;
  Vec3 normal;        ///< unit, from the surface to the centre
  Real distance = 0;  ///< along the normal; negative: the centre is inside the grain
  Real share = 1;     ///< see Touch
  bool found = false;
};

/// Descends from `start` to the nearest foot, in voxels.
///
/// Newton's method on the surface: with the tangential part e of c - x, its normal part d and
/// the shape operator S, step t along the surface and back to it,
///
///     (I + d S) t = e,    x <- x + t - (s/|grad s| + t.S t / 2) n
///
/// with the absolute values of the eigenvalues of I + d S (negative on a saddle), so that the step
/// goes downhill; steps that do not are shortened. Quadratic; about 3 evaluations.
/// A descent that comes within 0.4 voxel of one of the `known` feet ends there, with nothing found.
[[nodiscard]] Foot find_foot(const SurfaceSpline& spline, const Vec3& centre, const Vec3& start,
                             std::span<const Foot> known = {});

/// Gives feet that are dips of one and the same contact their shares of the force.
///
/// Two minima with overlaps a and b are two contacts only as far as the sphere leaves the grain
/// between them. Pores in pixels have small dips, where minima are born and die at finite overlap;
/// counted in full, they would make the force jump. With the overlap c at the saddle between them
///
///     F = F(a) n_a + F(b) n_b - F(c) n_c,    n_c ~ (e_b n_a + e_a n_b)/(e_a + e_b),
///     e_a = a - c,  e_b = b - c
///
/// is continuous: where a minimum is born b = c and n_c = n_b. F ~ overlap^(3/2). With more than two
/// the saddles are taken along the tree that joins the minima at greatest depth. Minima more than
/// 60 degrees apart are always two contacts, below 30 degrees in full as above, smoothly between.
/// Walls of a groove are never joined: between them the sphere is in the pore (c <= 0).
/// @param feet     all in one unit of length; `share` is set
/// @param overlap  at the saddle between two feet; zero or less: none
using SaddleOverlap = std::function<Real(const Foot& a, const Foot& b)>;
void share_force(std::span<Foot> feet, Real radius, const SaddleOverlap& overlap);

/// The same on a sampled surface. @param radius  [voxels] of the sphere
void share_force(const SurfaceSpline& spline, const Vec3& centre, Real radius,
                 std::span<Foot> feet);

/// The feet nearer than `within`, nearest first. The nearest foot knows whether the centre is in
/// the pore; then feet on the far side of a thin grain do not count. A centre in a grain leaves it
/// by the nearest way.
[[nodiscard]] std::span<Foot> keep_near_side(std::span<Foot> feet, Real within);

}  // namespace porefines::dem
