// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "flow/hierarchy.hpp"

namespace porefines::bench {

/// Bytes that must pass between memory and core: each field that a pass needs counted once per pass,
/// twice where it is changed. Ghosts, index arrays and write-allocates are not counted, as in STREAM.

/// Cells in lines of 16 that hold fluid, of this rank's block: what kernels work on.
Index active_cells(const flow::Level& level);

/// One fused sweep [bytes]. Per active cell:
///
///     u, v, w, p read and written         8
///     f (3), g, 1/d (3), push             8
///     W (3), on the finest level only     3
///     floats                             19 (76 bytes), on coarse levels 16 (64 bytes)
double sweep_bytes(const flow::Level& level);

/// One multigrid cycle [bytes]: for every visit of every level
///
///     clear u, v, w, p (first visit)                                 4 floats
///     2 sweeps before, 2 after (20 on the coarsest level)            see sweep_bytes
///     residual: u (3), p, f (3), g, 1/d (3), carry (3), push,
///               W (3) on the finest level; r (3), rg written         15 (18) + 4
///     restriction: r (3), rg; coarse f (3) scaled in place by 1/M    4 + 13 per coarse cell
///     prolongation: u, v, w, p changed, carry (3), push;
///               coarse u (3) and 1/M (3) to z (3), z and p           12 + 13 per coarse cell
///
/// Coarse levels mostly fit in cache: the share of the stream may exceed what memory alone allows.
double cycle_bytes(flow::Hierarchy& hierarchy);

}  // namespace porefines::bench
