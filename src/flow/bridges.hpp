// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "flow/boundary.hpp"
#include "flow/level.hpp"
#include "flow/links.hpp"

namespace porefines::flow {

/// Closes every face that alone joins a part of the pores to the rest, where no fluid enters that part.
///
/// What goes in through such a face cannot come out again: u = 0 by continuity, and the flow elsewhere is
/// the same without it. The pressure of the pocket behind it is then a constant of its own, not a
/// constraint that hangs on one small link: in rocks these were the slowest modes of the cycle.
/// In graph terms: bridges of the graph of cells and open faces (Tarjan 1974), in linear time, depth
/// first with a stack of its own. Faces on the border of the rank's block count as joined to all that lies
/// outside, so that every rank decides alone; what it closes is always right, but fewer pockets are
/// found on more ranks.
/// Memory while it runs: 8 bytes per cell of the block and 12 per pore cell.
/// @return  faces closed by this rank
/// Tests: unit/flow_bridges.
Index close_bridges(Level& level, const Boundaries& boundaries, Friction& friction);

}  // namespace porefines::flow
