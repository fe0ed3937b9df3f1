// SPDX-License-Identifier: MPL-2.0
// What the solver gives for spheres whose mobility is known exactly: references.md B1, B2, B4, B5, B6. The
// tests assert it, `porefines validate` prints it. Unit cells, unit viscosity; `size` is the diameter in
// cells. One rank; RunError where a solve does not converge.
#pragma once

#include <array>

#include "core/types.hpp"

namespace porefines::mobility {

/// F/(6 pi mu a U) of a sphere that a force drives towards a wall, its centre `height` radii above it
/// (B1, Brenner 1961). Above 1.3 radii the mean of two places against the grid, the other wall 10 diameters up
/// and images 12 away: half as far they add 1.1 % at 2.35 radii, 5 % at 3.76. Nearer the mean of ten places, which scatter
/// by 3 to 7 % where the gap is a tenth to a third of a cell, with walls half as far.
/// Test: verification/lubrication.
[[nodiscard]] Real wall_factor(int size, Real height);

/// A sphere `height` radii above a wall, held, dragged along it, or free in a shear flow (B2, Goldman, Cox
/// & Brenner 1967): the mean of two places. The lid that shears is 8 diameters up and images are 14 away: at
/// 6 they take 3 % off the drag. Test: verification/lubrication.
struct AlongWall {
  Real drag = 0;    ///< F/(6 pi mu a U), not turning
  Real force = 0;   ///< F/(6 pi mu a h S) in a shear flow of rate S, held
  Real torque = 0;  ///< T/(4 pi mu a^3 S), held
  Real speed = 0;   ///< U/(h S), free
  Real spin = 0;    ///< omega/(S/2), free
};
[[nodiscard]] AlongWall along_wall(int size, Real height);

/// U/U_max of a force-free sphere on the axis of a tube `1/ratio` times as wide (B4); images are 6 diameters
/// away, the wall is a grain surface. Test: verification/lubrication.
[[nodiscard]] Real tube_speed(int size, Real ratio);

/// F/(6 pi mu a U) of two equal spheres that approach each other, their centres `distance` radii apart (B5,
/// Stimson & Jeffery 1926), over `exact`: five directions against the grid. Images are 8 diameters away, 16 where
/// the spheres are more than 3 radii apart: at 8 they add 2.3 % to a pair along an axis. Test: verification/lubrication.
struct Approach {
  Real mean = 0;   ///< of the five
  Real worst = 0;  ///< |1 - that of one|
};
[[nodiscard]] Approach approach(int size, Real distance, Real exact);

/// F/(6 pi mu a U) of two equal spheres that go after each other along their line of centres under one force each, their
/// centres `distance` radii apart (B5): the mean of five directions against the grid. They lie in a periodic box 16 diameters
/// wide, in the frame of its mean flow; their images slow each by 2 * 2.837297 a/L of F/(6 pi mu a) (Hasimoto 1959), which is
/// given back. What is left is of order (r/L)^2 a/L: below 0.1 %. Test: verification/lubrication.
[[nodiscard]] Real together(int size, Real distance);

/// 8 pi mu a^3 omega/T of a sphere in a box whose walls are 4 radii away (B6): the mean of three places;
/// 1/1.013 in the limit of fine grids, which 24 cells a diameter have within 0.1 %.
/// Test: verification/free_spheres.
[[nodiscard]] Real turn_factor(int size);

/// omega/(G/2) of a free sphere in a shear flow of rate G, walls 4 diameters away (B6).
/// Test: verification/free_spheres.
[[nodiscard]] Real shear_spin(int size);

/// (eta/mu - 1)/phi of one free sphere in a shear flow (B6; Einstein 1906: 2.5), eta from the stress on the lid
/// 4 diameters above it, images 8 diameters away. Test: verification/free_spheres.
[[nodiscard]] Real intrinsic_viscosity(int size);

}  // namespace porefines::mobility
