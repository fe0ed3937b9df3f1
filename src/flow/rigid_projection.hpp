// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <vector>

#include "core/six.hpp"
#include "flow/inertial_flow.hpp"

namespace porefines::flow {

/// The explicit coupling of the thesis (Shirgaonkar et al. 2009, as in cfdemSolverIB), for comparison.
///
/// A step dt:
///
///     1. u += dt F/(rho V) on the faces inside each sphere
///     2. rho (u* - u)/dt - mu lap u* + grad p = f,  div u* = 0      everywhere, as if all were fluid
///     3. U, omega: the rigid motion nearest to u* in each sphere (its momenta); u = U + omega x r there
///        (on faces across its surface in part, by the share that is inside)
///
/// The next step's continuity makes up for what the third breaks. Spheres weigh as much as the fluid
/// that they replace; what they weigh more or less is part of F. Friction between a sphere and the
/// fluid beside it acts once a step: drag is too small by an amount that grows with nu dt/h^2
/// (verification/rigid_projection), which is why runs use the implicit solve.
class RigidProjection {
 public:
  /// @param flow  on `solver`, Euler in time
  RigidProjection(StokesSolver& solver, InertialFlow& flow, Real density,
                  const par::Communicator& comm)
      : parts_(solver.parts()), flow_(flow), density_(density), comm_(comm) {}

  /// @param owned  those whose centres are in this rank's block; held ones get their given motion
  /// @return  their motions; `force`, `torque` are those from outside, which the fluid balances
  /// Collective.
  [[nodiscard]] std::vector<SphereMotion> advance(Real step, const Drive& drive,
                                                  const std::vector<Sphere>& owned,
                                                  const StepOptions& options);
  /// Of the fluid's part of the last step.
  [[nodiscard]] const StepReport& report() const { return last_; }

 private:
  template <typename Visit>
  void for_faces(const Sphere& sphere, const Visit& visit) const;
  template <typename Visit>
  void for_faces_at(const Vec3& centre, Real radius, const Visit& visit) const;
  [[nodiscard]] std::vector<SixBySix> gather_moments(const std::vector<Sphere>& all) const;
  void kick(Real step, const std::vector<Sphere>& all, const std::vector<SixBySix>& factors);
  [[nodiscard]] std::vector<Six> fit(const std::vector<Sphere>& all,
                                     const std::vector<SixBySix>& factors) const;
  void put(const std::vector<Sphere>& all, const std::vector<Six>& motions);

  StokesSolver::Parts parts_;
  InertialFlow& flow_;
  Real density_;
  const par::Communicator& comm_;
  StepReport last_;
};

}  // namespace porefines::flow
