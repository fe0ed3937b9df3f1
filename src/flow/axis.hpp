// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <vector>

#include "flow/boundary.hpp"
#include "grid/block.hpp"

namespace porefines::flow {

/// Coefficients of the discrete operators along one axis of one level: grids are tensor products,
/// so every stencil coefficient depends on one index only.
///
/// With cell widths w_i (in fine cells of axis x) and d_i = (w_{i-1} + w_i)/2 between centres:
///
///     component normal to the axis, face i:   low 1/(w_{i-1} d_i),   high 1/(w_i d_i)
///     other components, cell i:               low 1/(w_i d_i),       high 1/(w_i d_{i+1})
///     gradient at face i: 1/d_i               divergence at cell i: 1/w_i
///
/// A pressure boundary is a mirror (u even, p odd): its face has low 0, high doubled, gradient
/// doubled, and needs no ghost values. A periodic axis of one cell has no coupling: all zero.
/// Arrays are read through at(): index -ghost .. n + ghost, padded to whole vector lines.
struct AxisCoefficients {
  int offset = 0;  ///< position of index 0 in every array
  std::vector<float> face_low, face_high;
  std::vector<float> cell_low, cell_high;
  std::vector<float> gradient;
  std::vector<float> divergence;
  std::vector<float> owned_cell;  ///< 1 where this rank owns the cell, else 0
  std::vector<float> owned_face;

  [[nodiscard]] float sum_at_face(int i) const {
    return face_low[i + offset] + face_high[i + offset];
  }
  [[nodiscard]] float sum_at_cell(int i) const {
    return cell_low[i + offset] + cell_high[i + offset];
  }
};

/// @param widths  of all cells of the axis (global), in fine cells of axis x
AxisCoefficients make_axis(const grid::Block& block, int axis, const std::vector<Real>& widths,
                           const Boundaries& boundaries);

/// Weights that carry values between a level and the next coarser one along one axis.
///
/// Coarse cell I covers fine cells 2I and, except perhaps at the end, 2I+1; on an axis that is kept,
/// with a ratio of 1, fine cell I alone. Indices are local to
/// the *fine* block: coarse index I here means fine start / 2 + I.
///   cells: coarse value = sum over children of (w_f/w_C) fine; fine value = coarse value.
///   faces along their normal: even fine faces coincide with coarse face I; odd ones lie between
///   coarse faces I and I+1 with weights 1/2. Restriction is the transpose times d_f/d_C.
struct AxisTransfer {
  bool coarsened = false;          ///< false: the axis has as many cells on both levels
  int ratio = 2;                   ///< fine cells per coarse one: 1 on an axis of long cells, kept
  std::vector<float> cell_first;   ///< per coarse cell: weight of child 2I
  std::vector<float> cell_second;  ///< weight of child 2I+1; 0 where there is none
  std::vector<float> face_before;  ///< per coarse face: weight of fine face 2I-1
  std::vector<float> face_middle;  ///< weight of fine face 2I
  std::vector<float> face_after;   ///< weight of fine face 2I+1
  std::vector<float> odd_low;      ///< per coarse cell: weight of coarse face I in fine face 2I+1
  std::vector<float> odd_high;     ///< weight of coarse face I+1
};

AxisTransfer make_transfer(const grid::Block& fine, int axis, const std::vector<Real>& fine_widths,
                           const std::vector<Real>& coarse_widths, const Boundaries& boundaries);

}  // namespace porefines::flow
