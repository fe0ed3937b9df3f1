// SPDX-License-Identifier: MPL-2.0
// Where a curve of energy against gap has its barrier and its minima.
#pragma once

#include <optional>

#include "surface/force_law.hpp"

namespace porefines::surface {

/// The top between two minima.
struct Barrier {
  Real gap = 0;     ///< [m]
  Real energy = 0;  ///< [J] against bodies far apart; below zero where attraction wins all along
};

/// A minimum, and the force that takes a body out of it.
struct Well {
  Real gap = 0;       ///< [m]
  Real energy = 0;    ///< [J]
  Real pull = 0;      ///< [N] greatest attraction on the way out, positive
  Real pull_gap = 0;  ///< [m] where
};

/// Whatever is absent does not exist: no barrier where conditions are favourable, no primary minimum without Born
/// repulsion (the energy falls without bound towards contact).
struct Landmarks {
  std::optional<Well> primary;
  std::optional<Barrier> barrier;
  std::optional<Well> secondary;  ///< outside of the barrier
};

/// Extrema of R v(h): sign changes of the force, and for the pull of the stiffness, at 200 gaps a decade from 1e-16 m to
/// 100 Debye lengths, refined by bisection. A barrier that rises and ends within 1 % of its gap is not seen. There is at
/// most one: of 20,000 laws drawn at random none had two.
/// Without a barrier a minimum is the primary one where it lies within a Born diameter, otherwise the secondary.
/// @param radius  [m] reduced radius R
/// Test: unit/surface_landmarks.
[[nodiscard]] Landmarks find_landmarks(const ForceLaw& law, Real radius);

}  // namespace porefines::surface
