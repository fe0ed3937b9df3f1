// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "flow/level.hpp"

namespace porefines::flow {

/// Rows [first, last) of one plane.
struct RowRange {
  int first;
  int last;
};

/// Gauss-Seidel on the faces of one colour, all three components, in rows of plane k:
///
///     u = (1/d) (f - W grad p + sum e u_nb)
///
/// Colour of a face: parity of its global index sum.
void relax_velocity(Level& level, int k, RowRange rows, int colour);

/// One component without pressure, over-relaxed: A u = f. For the mobility.
void relax_component(Level& level, int component, int k, RowRange rows, int colour, float omega);

/// Distributive update of the cells of one colour: makes each of them divergence-free.
///
///     q = (g - div W u) push;   p += omega q;   u -= (W/d) grad q
///
/// Every face has one cell of each colour at its sides, so one colour moves every face once.
void push_pressure(Level& level, int k, RowRange rows, int colour, float omega);

/// r = M (f - d u + sum e u_nb - W grad p) and rg = g - div W u in rows of plane k.
void find_residual(Level& level, int k, RowRange rows);

}  // namespace porefines::flow
