// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <functional>

#include "flow/level.hpp"

namespace porefines::flow {

/// Signed distance to the grains, > 0 in the fluid, in units of the fine cell along x, at a point
/// in the same units (origin: low corner of the grid). Reliable within two cells of the surface.
using SignedDistance = std::function<Real(const Vec3&)>;

/// Is the cell with these global indices pore? Asked one cell beyond the box as well.
using IsPore = std::function<bool(int i, int j, int k)>;

/// How far the diagonal of a momentum row exceeds the sum of its off-diagonals: the friction of
/// walls next to the face, 0 in the bulk. Kept apart from 1/d, so that the bulk operator has no
/// spurious friction from rounding. `inactive` marks faces where nothing flows.
struct Friction {
  static constexpr float inactive = 1e30F;
  Floats3 excess;
};

/// May a face of an axis (component 0, 1, 2), or a cell (3), at this local index along `axis` hold an
/// unknown? No faces on or beyond closed ends, no cells outside.
[[nodiscard]] bool exists(const grid::Block& block, const Boundaries& boundaries, int component,
                          int axis, int local);

/// Weighted links to a smooth grain surface (algorithm.md section 3), for every face of the level
/// (ghosts too).
///
///     face active iff s > 0 at its centre
///     theta along axis t, side e: 1 if s > 0 at the neighbour, else the distance to the wall from
///         the quadratic through s(0), s(1/2), s(1), in (0.02, 1]
///     d = sum over links of e_t / theta,  W = (1 + V)/2,  V = sum n_t^2 (theta_t- + theta_t+)/2
///
/// with n the unit normal. Box walls are links of half a cell, weighted the same way: a slit of n cells
/// then has k = h^2/12 (1 + 1/(2 n^2)), four times nearer than with W = 1. Slip takes e_t off.
/// Second order in the mean; a throat under 4 cells is off by more than 3 %.
/// Tests: verification/sphere_arrays, verification/cylinder_arrays.
Friction link_to_surface(Level& finest, const Boundaries& boundaries,
                         const SignedDistance& distance);

/// Links on the pixel staircase itself: walls are voxel faces half a cell away and W = 1, as in any
/// finite-volume code on the same voxels.
Friction link_to_voxels(Level& finest, const Boundaries& boundaries, const IsPore& is_pore);

/// Takes out faces through which nothing can flow: one of their cells has no other open face.
///
/// By continuity u = 0 there, so the flow elsewhere is the same without them; what goes is the
/// pressure of the dead-end cell, a constraint that coarse levels cannot see and that made cycles
/// diverge where a grain lies flat on a grid plane. Repeated until no dead end is left.
/// Call before finish_level; collective.
/// @return  faces taken out, over all ranks
Index prune_dead_ends(const par::Communicator& comm, Level& finest, const Boundaries& boundaries,
                      Friction& friction);

}  // namespace porefines::flow
