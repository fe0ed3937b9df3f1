// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <vector>

#include "flow/face_velocity.hpp"

namespace porefines::flow {

/// How a velocity is interpolated to where it is carried through.
enum class Scheme {
  linear,  ///< mean of both sides: second order, conserves energy, waves where a cell's Re is large
  lust,    ///< 75 % linear + 25 % linear-upwind: second order, damps those waves
  none     ///< momentum is not carried: the unsteady creeping flow
};

/// Carriage of momentum, div(u u), on the faces of the finest level, per unit volume:
///
///     A(u, v)_f = sum over axes of (F_high v_high - F_low v_low)/h,   F = mean of W u
///
/// F, the flux through a side of the control volume of f, is the mean of the two fluxes that the
/// continuity equation of the cells beside f knows: what enters a control volume leaves it again, at cut
/// links too, so that with linear interpolation sum u A(u, u) = 0: energy is neither made nor lost.
/// Interpolation at a side between P and N, D being the second difference at the cell upwind:
///
///     v = (v_P + v_N)/2 - kappa D,   kappa = 0 (linear), 1/16 (LUST)
///
/// Where D would need a value beyond the box, it is left out. At openings the velocity normal to them is
/// carried by u du/dn (outwards only) + u_t du/dt: their control volume is half outside.
/// Weller, "LUST" in OpenFOAM; Verstappen & Veldman, J. Comput. Phys. 187 (2003) 343-368 (symmetry).
/// Tests: verification/taylor_green (order, energy), verification/cavity.
class Advection {
 public:
  Advection(const Level& level, const Boundaries& boundaries, Scheme scheme);

  /// out = A(u, u) on the unknowns that this rank owns; 0 elsewhere. Local: load() has filled u.
  void apply(const Operator& op, const FaceVelocity& u, Packed<float>& out) const;
  /// out = A(u, z) + A(z, u): how A(u, u) changes with u, to first order.
  void change(const Operator& op, const FaceVelocity& u, const FaceVelocity& z,
              Packed<float>& out) const;

 private:
  template <bool upwind, bool linearised>
  void run(const Operator& op, const FaceVelocity& u, const FaceVelocity& z,
           Packed<float>& out) const;
  void carry_openings(const Operator& op, const FaceVelocity& u, const FaceVelocity& z,
                      bool linearised, Packed<float>& out) const;

  const Level& level_;
  Boundaries boundaries_;
  Scheme scheme_;
  std::array<std::vector<float>, 3> bends_face_;  ///< 1 where both neighbours along the axis exist
  std::array<std::vector<float>, 3> bends_cell_;
  std::array<float, 3> per_width_{};
  std::array<bool, 3> moves_{};  ///< has the component any unknown here?
};

}  // namespace porefines::flow
