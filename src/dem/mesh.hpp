// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dem/touch.hpp"
#include "geom/stl.hpp"

namespace porefines::dem {

/// Triangles with shared corners, ready for contact.
struct Mesh {
  using Corners = std::array<std::int32_t, 3>;

  std::vector<Vec3> vertex;                ///< [m]
  std::vector<Corners> face;               ///< counter-clockwise seen from the particles
  std::vector<Vec3> normal;                ///< unit, of each face
  std::vector<Corners> beside;             ///< face across the edge corner k - corner k+1; -1: none
  std::vector<std::int32_t> first_around;  ///< per vertex, and one more: its faces in `around`
  std::vector<std::int32_t> around;
  bool closed = false;  ///< every edge has two faces: has an inside; else particles on both sides
  Index dropped = 0;    ///< triangles without area, left out

  Vec3 low;       ///< [m] corner of the search grid
  Real cell = 1;  ///< [m]
  Int3 cells{1, 1, 1};
  std::vector<std::int32_t> start;  ///< per cell, and one more
  std::vector<std::int32_t> list;   ///< faces whose box meets the cell
  std::vector<Int3> first_cell;     ///< per face: lowest cell that its box meets
  std::vector<Vec3> middle;         ///< [m] per face: centre of its box
  std::vector<Real> extent;         ///< [m] per face: from there to its corners at most
};

/// Joins corners that coincide and builds the search grid.
/// @param largest  [m] radius + reach of the largest sphere: sets the size of cells only
/// Errors: InputError when nothing is left or a coordinate is not finite.
[[nodiscard]] Mesh make_mesh(const std::vector<geom::Triangle>& triangles, Real largest);

/// Touches with gap < reach: one per local minimum of the distance to the surface.
///
/// The nearest point of a triangle counts when no triangle that shares it comes nearer: a face always
/// does, an edge or corner only where the surface is convex, and a point between coplanar triangles
/// once. Facets of a hollow share the force as in share_force. The feature is 0: history follows
/// the normal (match_histories), from triangle to triangle.
/// Test: unit/dem_mesh, verification/grain_contact.
void find_touches(const Mesh& mesh, const Vec3& centre, Real radius, Real reach, TouchList& out);

/// Triangles of a binary or ASCII STL file.
/// @param unit  [m] of its numbers
/// Errors: InputError when it cannot be read, is cut short or holds no triangles.
[[nodiscard]] std::vector<geom::Triangle> read_stl(const std::string& path, Real unit);

}  // namespace porefines::dem
