// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <vector>

#include "core/aligned.hpp"
#include "flow/axis.hpp"
#include "flow/boundary.hpp"
#include "grid/block.hpp"
#include "grid/halo.hpp"
#include "par/communicator.hpp"

namespace porefines::flow {

using Floats = AlignedVector<float>;
using Floats3 = std::array<Floats, 3>;

/// Lines of 16 cells that hold any fluid, row by row: solid costs neither time nor bandwidth.
struct ActiveLines {
  std::vector<int> row_first;  ///< per memory row (j, k): first entry in `x`
  std::vector<int> x;          ///< local x index of the line's first cell

  [[nodiscard]] Index count() const { return static_cast<Index>(x.size()); }
};

/// One grid of the multigrid hierarchy, in scaled units: length = fine cell along x, viscosity = 1.
///
/// Rows of the system, in finite-difference form (per unit volume):
///
///     momentum at a face:  d u - sum e u_nb + W (p_i - p_{i-1}) grad = f
///     continuity in a cell:  sum of +-W u div = g
///
/// e, grad and div are the AxisCoefficients. Where nothing flows inverse_diagonal is 0, and so u.
/// W is the link weight of grain surfaces; it is 1 on coarse levels and not stored there.
struct Level {
  par::Decomposition decomposition;
  grid::Block block;
  grid::Halo halo;
  std::array<std::vector<Real>, 3> widths;  ///< of all cells of the grid, in fine cells along x
  std::array<AxisCoefficients, 3> axis;
  bool replicated = false;  ///< every rank holds the whole grid
  std::array<bool, 3> flows{true, true,
                            true};  ///< has the component an open face, ghosts included?

  Floats3 inverse_diagonal;  ///< 1/d, 0 at inactive faces
  Floats3 weight;            ///< W, finest level only
  Floats3 mobility;          ///< M of A M = W; makes the coarse levels, then is released
  Floats3 carry;             ///< share of a face in the flux of a coarse one (Transfer)
  Floats push;               ///< 1 / sum(W^2 grad div / d) over the faces of a cell; 0 if inactive
  ActiveLines lines;

  Floats3 u;  ///< velocity (correction)
  Floats p;   ///< pressure (correction)
  Floats3 f;  ///< momentum right-hand side
  Floats g;   ///< continuity right-hand side
  Floats3 r;  ///< carry times momentum residual, on its way to the coarse level
  Floats rg;  ///< continuity residual
  bool lends_sides =
      true;  ///< r and rg are empty and f and g take the residual: saves 16 bytes a cell

  Level(const par::Communicator& comm, const par::Decomposition& cut,
        std::array<std::vector<Real>, 3> cell_widths, const Boundaries& boundaries, int ghost_depth,
        bool finest);

  /// Does this rank own an unknown? component 3: the pressure of a cell.
  [[nodiscard]] bool owns(int component, const Int3& index) const {
    for (int a = 0; a < 3; ++a) {
      const auto& owned = a == component ? axis[a].owned_face : axis[a].owned_cell;
      if (owned[index[a] + axis[a].offset] == 0) {
        return false;
      }
    }
    return true;
  }

  /// Where the residual of a component goes; 3: continuity.
  [[nodiscard]] float* residual_of(int component) {
    return lends_sides ? (component < 3 ? f[component] : g).data()
                       : (component < 3 ? r[component] : rg).data();
  }
  /// Gives r and rg memory of their own, or takes it back.
  void lend_sides(bool lend);

  [[nodiscard]] bool weighted() const { return !weight[0].empty(); }
  /// W M at a face.
  [[nodiscard]] Real weighted_mobility(int component, std::ptrdiff_t face) const {
    const Real m = mobility[component][face];
    return weighted() ? m * weight[component][face] : m;
  }
  [[nodiscard]] std::size_t bytes() const;

  /// Exchanges ghosts of u and p.
  void exchange_unknowns(int depth);
  void exchange_sides(int depth);  ///< f and g
};

/// Calls work(x) for every active line of row (j, k), x being the local index of its first cell.
template <typename Work>
void for_lines(const Level& level, int j, int k, const Work& work) {
  const grid::Block& b = level.block;
  const int row = (j + b.ghost[1]) + (k + b.ghost[2]) * static_cast<int>(b.sz / b.sy);
  const int last = level.lines.row_first[row + 1];
  for (int entry = level.lines.row_first[row]; entry < last; ++entry) {
    work(level.lines.x[entry]);
  }
}

/// push of one cell: 1 / sum over its six faces of W^2 grad div / d; 0 where none is open.
[[nodiscard]] float push_of(const Level& level, const Int3& cell);

/// Finds active lines, the push coefficient and which components flow; call when diagonals and weights (ghosts too) stand.
void finish_level(Level& level);

}  // namespace porefines::flow
