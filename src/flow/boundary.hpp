// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>

#include "core/types.hpp"

namespace porefines::flow {

/// What the fluid meets at a face of the box.
///
/// - periodic: the opposite face.
/// - wall: no slip, u = 0.
/// - slip: symmetry plane, u_n = 0 and du_t/dn = 0.
/// - pressure: p given on the face, flow crosses it normally (u_t = 0, du_n/dn = 0): the symmetry
///   of a Stokes flow whose pressure is odd about the face. Exact for a straight duct.
/// - velocity: u_n given where the face is open, u_t = 0.
/// - outflow: p given on the face, du/dn = 0 for all components: lets vortices leave.
/// - lid: a wall that moves in its own plane, u_t given.
enum class FaceKind { periodic, wall, slip, pressure, velocity, outflow, lid };

/// Is the pressure given there?
[[nodiscard]] constexpr bool gives_pressure(FaceKind kind) {
  return kind == FaceKind::pressure || kind == FaceKind::outflow;
}

/// Kinds of the six box faces, indexed by BoxFace.
struct Boundaries {
  std::array<FaceKind, 6> kind{FaceKind::periodic, FaceKind::periodic, FaceKind::periodic,
                               FaceKind::periodic, FaceKind::periodic, FaceKind::periodic};

  [[nodiscard]] FaceKind at(int axis, bool high) const { return kind[2 * axis + (high ? 1 : 0)]; }
  [[nodiscard]] bool periodic(int axis) const { return at(axis, false) == FaceKind::periodic; }
  [[nodiscard]] std::array<bool, 3> periodic() const {
    return {periodic(0), periodic(1), periodic(2)};
  }
  /// Does a velocity unknown live on this box face?
  [[nodiscard]] bool open(int axis, bool high) const {
    return at(axis, high) == FaceKind::periodic || gives_pressure(at(axis, high));
  }
};

}  // namespace porefines::flow
