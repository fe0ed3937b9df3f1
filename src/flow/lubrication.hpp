// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <span>
#include <vector>

#include "flow/sphere_set.hpp"

namespace porefines::flow {

inline constexpr Real lubrication_range = 2;  ///< [cells] gaps beyond it the grid resolves

/// The gap between a sphere and the wall or grain next to it.
struct WallGap {
  std::size_t sphere = 0;  ///< in the list of this rank's spheres
  Vec3 normal;             ///< unit vector from the wall to the sphere
  Real gap = 0;            ///< surface to surface; negative where they overlap
  Real share = 1;          ///< of the friction: touches that merge share it
};

/// What the grid misses of the friction across a narrow gap, in fine cells and viscosity 1.
///
/// With a the radius, a_r = a1 a2/(a1 + a2) (a at a wall), g the gap in cells, not below the height
/// of roughness:
///
///     squeeze:      6 pi a_r^2 f(g) (U1 - U2).n        f = (1 - s(g))/g below 2 cells
///     at a wall:    pi a L (0.8 slip at the contact, 2.4 U_t, 2.4 a^2 omega_t)
///     two spheres:  pi a L (slip, 0.6 a^2 (omega1 - omega2)_t),  a = 2 a_r
///                   L = ln(0.373/g) below 0.373 cells
///
/// These are the leading terms of the exact resistances: 6 pi a_r^2/g (Brenner 1961; Cox 1974),
/// (8/15, 2/15, 2/5) ln(a/g) (Goldman, Cox & Brenner 1967), (1/6, 1/5, 1/20) ln(a/g) (Jeffrey &
/// Onishi 1984). s is the share that the grid resolves, measured for D = 6, 8 and 12 cells: the rest
/// scales with a_r^2 and depends on g alone; so does the length in L. Towards a wall the sum is right
/// to 2 %, to 1 % from a gap of one cell on; between two spheres it is so in the mean over directions,
/// single ones are off by up to a quarter where the gap is a fifth of a cell.
/// Tests: verification/lubrication (tables B1, B5 of references.md).
struct Lubrication {
  int first = 0;    ///< held ball
  int second = -1;  ///< held ball, or -1: a wall
  Vec3 normal;      ///< from second to first
  Real radius_first = 0;
  Real radius_second = 0;
  Real squeeze = 0;  ///< 6 pi a_r^2 f
  Real shear = 0;    ///< pi a L
  Real gap = 0;      ///< negative where they overlap
  Real least = 0;    ///< height of roughness
  bool touching = false;
};

/// Squeeze force between two that touch and come nearer, times `factor`: added to both. It stands for
/// their contact, as what presses them together is balanced by it until the contact force is told.
void add_contact(const Lubrication& gap, const std::vector<Six>& motion, Real factor,
                 std::vector<Six>& force);

/// (1 - s(g))/g; zero from lubrication_range on.
[[nodiscard]] Real missing_squeeze(Real gap, bool wall);

/// All gaps that this rank counts: of balls whose contact lies in its block, and the walls given.
[[nodiscard]] std::vector<Lubrication> find_lubrication(const SphereSet& set,
                                                        const grid::Block& block,
                                                        std::span<const WallGap> walls,
                                                        Real roughness);

/// Adds the forces on both sides, times `factor`.
void add_lubrication(const Lubrication& gap, const std::vector<Six>& motion, Real factor,
                     std::vector<Six>& force);

/// Adds minus the derivative of each side's force by its own motion.
void add_own_blocks(const Lubrication& gap, Real factor, std::vector<SixBySix>& blocks);

}  // namespace porefines::flow
