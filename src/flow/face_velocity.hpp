// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>

#include "flow/operator.hpp"

namespace porefines::flow {

/// Velocity on the faces of the finest level together with what advection reads beyond its unknowns:
/// two layers of neighbours, inlets, and the sides of openings. In the units of the solve.
///
/// Memory as in the level's fields, with two planes to spare at both ends: a stencil of two cells
/// may look over the edge of the box, where a mask takes the value out.
class FaceVelocity {
 public:
  FaceVelocity(const Level& level, const Boundaries& boundaries);

  /// The unknowns of a packed vector, and `inlet` [per box face] at velocity faces. `carrier` says
  /// which way an outflow goes: its own velocity, or that around which this one is a change.
  /// Collective.
  ///
  /// Tangential velocity beyond a box face: -u where it is 0 on the face; u at an outflow, but 0 where
  /// fluid comes back through it: that half of u takes as much energy as it brings.
  template <typename T>
  void load(Level& level, const Operator& op, const Packed<T>& values,
            const std::array<Real, 6>& inlet, const FaceVelocity& carrier);

  [[nodiscard]] const float* data(int component) const { return field_[component].data() + pad_; }
  [[nodiscard]] float* data(int component) { return field_[component].data() + pad_; }

 private:
  void fill_side(const Level& level, int axis, bool high, const std::array<Real, 6>& inlet,
                 const FaceVelocity& carrier);

  Boundaries boundaries_;
  std::ptrdiff_t pad_;
  Floats3 field_;
};

}  // namespace porefines::flow
