// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>

#include "flow/face_network.hpp"
#include "flow/level.hpp"

namespace porefines::flow {

/// Network of a coarse face: the fine mobility W M around it as conductances.
/// @param coarse_face  position in coarse cells, relative to the fine block's first
FaceNetwork network_of(const Level& fine, const std::array<AxisTransfer, 3>& axis, int component,
                       const Int3& coarse_face);

/// Mobility of a coarse face from the fine one:
///
///     M_H = sqrt(M_plane M_network)
///
/// M_plane = mean of W M over the fine faces that make up the coarse one: what flows if pressure falls
/// evenly all around, as in a straight channel at any angle; an upper bound. M_network: what flows
/// if nothing leaves through the sides (effective_conductance); a lower one, but it sees a narrow
/// passage that turns inside a coarse cell. Cycles to 1e-6, on two 100^3 blocks of Berea, a
/// micromodel and a sandpack slice: M_plane alone 15 16 9 21, network alone 17 15 13 38, their
/// geometric mean 15 14 8 19; the mean of W M over the control volume (algorithm.md section 2) 17 18 9 25.
float coarse_mobility(const Level& fine, const std::array<AxisTransfer, 3>& axis, int component,
                      const Int3& coarse_face);

}  // namespace porefines::flow
