// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>

#include "core/types.hpp"

namespace porefines::flow {

/// The fine cells on both sides of a coarse face as a network of resistors: two layers of 2 x 2 cells,
/// one on each side of the face, and the outer layers behind them.
///
/// Conductances are in units in which a pore without walls has the mobility of its fine faces.
struct FaceNetwork {
  static constexpr Real held = 1e6;  ///< times a conductance: as good as a given pressure

  std::array<Real, 4> middle{};  ///< through the coarse face, from cell(0, p, q) to cell(1, p, q)
  std::array<Real, 8> outer{};  ///< from a cell through the outer layer to its coarse cell's centre
  std::array<std::array<Real, 8>, 2> across{};  ///< to the next cell along p and q; at p, q = 0
  std::array<bool, 8> sideways{};  ///< the cell leads out of its coarse cell across the normal

  /// Index of a cell: side 0 below the face and 1 above it; p and q: place along the axes across.
  static constexpr int cell(int side, int p, int q) { return 4 * side + 2 * q + p; }
};

/// Conductance between the centres of the two coarse cells, which hold pressures 1 and 0:
///
///     sum over neighbours k (p_c - p_nb) = 0 in the eight cells,   K = sum of k_outer p_c, side 1
///
/// Series and parallel ways count as they are, also where a throat one cell wide turns inside a
/// coarse cell. Cells of a layer that are reached only sideways hold the pressure of their coarse cell:
/// what leads there is counted in other faces. 0: no way through.
/// Tests: unit/flow_face_network.
Real effective_conductance(const FaceNetwork& network);

}  // namespace porefines::flow
