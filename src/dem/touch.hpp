// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/types.hpp"

namespace porefines::dem {

/// One place where a sphere meets a fixed or moving surface.
///
/// The surface point nearest to the sphere's centre c, locally: x = c - (radius + gap) normal.
/// A sphere has one touch per local minimum of |x - c| over the surface, so two in a groove.
struct Touch {
  Vec3 normal;         ///< unit, from the surface towards the centre: the push on the sphere
  Real gap = 0;        ///< [m] sphere to surface; negative: overlap
  Vec3 velocity;       ///< [m/s] of the surface at the touch
  Real curvature = 0;  ///< [1/m] mean curvature of the surface, > 0 where it bulges towards the
                       ///< sphere (1/radius of a round grain): 1/R = 1/radius + curvature in Hertz
  Real share = 1;      ///< factor on the force of the contact law, 0..1; below 1 where two touches
                       ///< are about to merge, so that the total stays continuous
  std::uint32_t feature = 0;  ///< which body of the surface; several touches may carry the same
};

/// The touches of one sphere. Nothing is dropped in silence: look at `lost`, `inside`, `uncovered`.
struct TouchList {
  static constexpr int capacity = 16;

  std::array<Touch, capacity> touch;
  int count = 0;
  int lost = 0;            ///< touches that found no place
  bool inside = false;     ///< the centre is inside a grain (the touch still pushes it out)
  bool uncovered = false;  ///< the sphere reaches beyond what this rank knows of the surface

  void clear() { count = lost = 0, inside = uncovered = false; }
  void add(const Touch& t) {
    if (count < capacity) {
      touch[static_cast<std::size_t>(count++)] = t;
    } else {
      ++lost;
    }
  }
  [[nodiscard]] bool in_trouble() const { return lost > 0 || inside || uncovered; }
  [[nodiscard]] std::span<const Touch> view() const {
    return {touch.data(), static_cast<std::size_t>(count)};
  }
};

/// Cosine of the largest turn of a normal between two substeps of one contact (26 degrees).
inline constexpr Real same_contact = 0.9;

/// Where the history of a touch is: the entry of the same feature whose normal turned least,
/// or -1 for a new contact. An entry needs members `feature` and `normal` (of the last substep).
///
/// A sphere that rolls over a smooth surface or over coplanar triangles keeps its history, and two
/// touches on one grain keep theirs apart. Call it for the touches in order and take a matched entry
/// out of the running with `taken`.
template <class Entry>
[[nodiscard]] int find_history(const Touch& touch, std::span<const Entry> before,
                               std::span<const bool> taken) {
  int best = -1;
  Real closest = same_contact;
  for (std::size_t e = 0; e < before.size(); ++e) {
    const Real turn = dot(before[e].normal, touch.normal);
    if (!taken[e] && before[e].feature == touch.feature && turn > closest) {
      best = static_cast<int>(e);
      closest = turn;
    }
  }
  return best;
}

}  // namespace porefines::dem
