// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <functional>
#include <vector>

#include "flow/inertial_flow.hpp"

namespace porefines::flow {

/// Force of the fluid on bodies that stand still: the momentum that its rows lose at their links.
///
///     F = sum k u (cut links and closed neighbours) + sum p (W_low - W_high)/h (cells beside them)
///         + momentum carried through the sides of control volumes that face a body
///
/// over faces and cells, times the volume of a cell. No traction is differenced at the wall: in a
/// periodic box the forces add up to that which drives the fluid. The walls of the box are left out.
/// With LUST the last term, which vanishes with h^2, lacks its upwind part.
/// Tests: verification/inertial_forces.
class BodyForces {
 public:
  /// @param body_of  which body a point [m from the low corner] belongs to, 0 .. bodies - 1; -1: none
  BodyForces(InertialFlow& flow, StokesSolver& solver,
             const std::function<int(const Vec3&)>& body_of, int bodies);

  /// [N] on each body, by the last step. Collective.
  [[nodiscard]] std::vector<Vec3> sum(const Drive& drive);

 private:
  struct Pull {  ///< of a velocity or a pressure
    int body, axis;
    std::ptrdiff_t at;
    Real factor;
  };
  struct Through {  ///< momentum carried into a closed neighbour
    int body, axis, along;
    std::ptrdiff_t at, first, second;  ///< the face; the two that carry
    Real factor;
  };
  void add_face(const Boundaries& boundaries, int c, const Int3& index, int body);
  void add_cell(const Boundaries& boundaries, const Int3& index, std::size_t packed, int body);

  InertialFlow& flow_;
  StokesSolver::Parts parts_;
  const Level& level_;
  int bodies_;
  std::vector<Pull> friction_;
  std::vector<Pull> pressure_;
  std::vector<Through> through_;
};

}  // namespace porefines::flow
