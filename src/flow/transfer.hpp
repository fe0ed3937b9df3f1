// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <vector>

#include "flow/level.hpp"

namespace porefines::flow {

/// Carries residuals to a coarse level and corrections back:
///
///     u_fine += C P u_coarse,       p_fine += p_coarse
///     f_coarse = P^T C r_fine,      g_coarse = mean of g
///
/// P is linear along the component's normal and constant across it (AxisTransfer). The carry C shares
/// the flux of a coarse face among the fine ones in a plane as the mobility does,
///
///     C = M / mean(W M)     over the fine faces in that plane that belong to one coarse face,
///
/// so that no flux is lost and the coarse pressure gradient needs no weight. M knows how velocity
/// varies inside a pore, so P only has to carry what varies on the scale of coarse cells.
/// Where the coarse level is replicated and the fine one is not, ranks exchange their parts.
class Transfer {
 public:
  Transfer(const par::Communicator& comm, const Level& fine, const Level& coarse,
           const Boundaries& boundaries);

  /// Mobility of the coarse level (coarse_mobility), ghosts not filled.
  void restrict_mobility(const Level& fine, Level& coarse) const;

  /// Finds the carry of the fine level, ghosts too, from its mobility.
  void share_flux(Level& fine) const;

  /// Expects find_residual(fine); leaves f and g of the coarse level, ghosts not filled.
  void restrict_residual(Level& fine, Level& coarse) const;

  /// Adds the coarse correction to the unknowns that the fine level owns.
  void prolong(Level& coarse, Level& fine) const;

 private:
  struct Part {
    Int3 first;
    Int3 last;
  };
  void restrict_faces(int component, const float* fine_field, const Level& fine, Floats& out,
                      const Level& coarse) const;
  void restrict_cells(Level& fine, Level& coarse) const;
  /// Mean of W M over the fine faces in the plane of `face` that belong to one coarse face.
  [[nodiscard]] Real mean_across(int component, const Level& fine, const Int3& face) const;
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
