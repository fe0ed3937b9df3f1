// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <vector>

#include "flow/level.hpp"

namespace porefines::flow {

/// Carries residuals to a coarse level and corrections back, weighted with the mobility:
///
///     u_fine += M_fine  P (u_coarse / M_coarse),       p_fine += p_coarse
///     f_coarse = (1 / M_coarse) P^T (M_fine r_fine),   g_coarse = mean of g
///
/// P is linear along the component's normal and constant across it (AxisTransfer). M knows how
/// velocity varies inside a pore, so P only has to carry what varies on the scale of coarse cells.
/// Where the coarse level is replicated and the fine one is not, ranks exchange their parts.
class Transfer {
 public:
  Transfer(const par::Communicator& comm, const Level& fine, const Level& coarse,
           const Boundaries& boundaries);

  /// Coarse mobility from W M over the control volume of every coarse face; 0 where no fine face in the
  /// plane of the coarse one is open.
  ///
  /// Across the flow conductances add up: the mean. Along it resistances do: between the arithmetic
  /// mean of algorithm.md and the harmonic one, their geometric mean converges best (16 -> 13 cycles
  /// on a 100^3 block of Berea, 8 -> 9 on a sphere array of 64^3; harmonic alone 14 and 11).
  void restrict_mobility(Level& fine, Level& coarse) const;

  /// What the transfers multiply with: carry of the fine level, inverse mobility of the coarse one.
  /// Call when the coarse mobility stands, ghosts too.
  void link_levels(Level& fine, Level& coarse) const;

  /// Expects find_residual(fine); leaves f and g of the coarse level, ghosts not filled.
  void restrict_residual(const Level& fine, Level& coarse) const;

  /// Adds the coarse correction to the unknowns that the fine level owns.
  void prolong(Level& coarse, Level& fine) const;

 private:
  /// Fine planes that make a coarse face.
  enum class Planes { all, before, middle, after };
  struct Part {
    Int3 first;
    Int3 last;
  };
  void restrict_faces(int component, const Floats& fine_field, const Level& fine, Floats& out,
                      const Level& coarse, Planes planes) const;
  void restrict_cells(const Level& fine, Level& coarse) const;
  void prolong_faces(int component, const Level& coarse, Level& fine) const;
  void prolong_cells(const Level& coarse, Level& fine) const;
  void gather(std::vector<float*> fields, const Level& coarse) const;

  MPI_Comm comm_;
  std::array<AxisTransfer, 3> axis_;
  Int3 offset_{};            ///< coarse local index of the coarse cell that holds fine cell 0
  std::vector<Part> parts_;  ///< what each rank contributes; empty: nothing to gather
  int rank_ = 0;
};

}  // namespace porefines::flow
