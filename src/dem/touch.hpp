// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <algorithm>
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

/// Where the history of each touch is: the place of its entry in `before`, or -1 for a new contact.
/// An entry needs members `feature` and `normal` (of the last substep).
///
/// Entries go to the touch of the same feature whose normal turned least, the closest pair first and
/// each once. So a sphere that rolls over a smooth surface or over coplanar triangles keeps its
/// history, two touches on one grain keep theirs apart, and one that is born beside another, before
/// it in the list or after, begins without.
template <class Entry>
[[nodiscard]] std::array<int, TouchList::capacity> match_histories(std::span<const Touch> touches,
                                                                   std::span<const Entry> before) {
  std::array<int, TouchList::capacity> found;
  found.fill(-1);
  std::array<bool, TouchList::capacity> taken{};
  const std::size_t most = std::min(touches.size(), before.size());
  for (std::size_t round = 0; round < most; ++round) {
    std::size_t touch = touches.size();
    std::size_t entry = 0;
    Real closest = same_contact;
    for (std::size_t t = 0; t < touches.size(); ++t) {
      for (std::size_t e = 0; e < before.size(); ++e) {
        const Real turn = dot(before[e].normal, touches[t].normal);
        if (found[t] < 0 && !taken[e] && before[e].feature == touches[t].feature &&
            turn > closest) {
          touch = t, entry = e, closest = turn;
        }
      }
    }
    if (touch == touches.size()) {
      break;
    }
    found[touch] = static_cast<int>(entry), taken[entry] = true;
  }
  return found;
}

}  // namespace porefines::dem
