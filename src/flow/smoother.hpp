// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "flow/level.hpp"

namespace porefines::flow {

/// Ghost layers that one fused sweep consumes: its four stages widen each other's reach.
inline constexpr int sweep_depth = 4;

/// One smoothing sweep: both colours of velocity, then both colours of pressure push.
///
/// The four stages run as one wave through the block, plane behind plane and in tiles of rows, so
/// that u, p, f and the coefficients pass through memory once instead of four times. Ghosts are
/// exchanged once, before the wave; the stages recompute what they need of the neighbour's cells.
/// The result is the same as stage after stage, on any number of ranks.
///
/// @param reversed  colours in the opposite order: post-smoothing mirrors pre-smoothing
/// @param from_zero u and p are known to be zero: no exchange is needed
void sweep(Level& level, bool reversed, bool from_zero);

/// `count` successive over-relaxation sweeps of A u_c = f_c for one component, no pressure.
void relax_mobility(Level& level, int component, int count, float omega);

/// r and rg of the level, valid one layer beyond the block on cut and periodic axes.
void find_residual(Level& level);

}  // namespace porefines::flow
