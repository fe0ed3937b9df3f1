// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "dem/contact_law.hpp"

namespace porefines::dem {

/// Shear force along one direction under partial slip, as a function of its history.
///
///     loading    dT/ds = k (1 - T / cap)^(1/3)
///     unloading  dT/ds = k (1 - (T1 - T) / 2 cap)^(1/3)      from T1
///     reloading  dT/ds = k (1 - (T - T2) / 2 cap)^(1/3)      from T2,    k = 8 G a, cap = mu N
///
/// integrated exactly over the step at the present N; the change of N moves the curves by mu dN
/// (Thornton & Yin 1991). A reversal inside a loop starts a new loop: outer ones are forgotten.
struct ShearBranch {
  Real shear = 0;   ///< [N] T
  Real unload = 0;  ///< [N] T1
  Real reload = 0;  ///< [N] T2
  Real branch = 0;  ///< 0 loading, 1 unloading, 2 reloading
};

/// @param slide      [m] displacement of the step, positive where it raises T
/// @param change     [N] mu dN
/// @return true when the unloading has become loading the other way: the caller turns its axis
[[nodiscard]] bool follow(ShearBranch& s, Real stiffness, Real cap, Real slide, Real change);

/// Tangential force with the micro-slip of Mindlin & Deresiewicz (1953): `"mindlin-deresiewicz"`.
///
/// Exact for loading, unloading and reloading along one direction at constant normal force; across
/// that direction a spring without slip. Costs about ten times Mindlin, so it is not the default.
/// Ref: Thornton & Yin, Powder Technol. 65 (1991) 153. Test: verification/partial_slip.
struct MindlinDeresiewicz {
  static constexpr int memory = history_size;

  [[nodiscard]] Vec3 operator()(const PairMaterial& pair, const ContactState& contact,
                                const NormalResponse& normal, Real dt, ContactHistory& h) const;
};

}  // namespace porefines::dem
