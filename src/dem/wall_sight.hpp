// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <vector>

#include "dem/touch.hpp"

namespace porefines::dem {

/// What a sphere near a surface that stays saw last, good until it has gone `far_enough` radii:
///
///     gap(x) = gap(x0) + n.(x - x0) + O(|x - x0|^2 / r)
///
/// so gaps are right to 5e-8 radii there (twice that where the grain is as round as the sphere), and
/// what comes into reach meanwhile is late by 3e-4 radii at most. An overdamped contact takes
/// thousands of substeps on its spot: searching a photographed grain in each was a third of a run.
/// Test: unit/dem_wall_sight.
class Sight {
 public:
  static constexpr Real far_enough = 3e-4;

  /// Adds to `out` the touches of a sphere at `x`, unless it has gone too far from where it looked.
  [[nodiscard]] bool recall(const Vec3& x, Real radius, Real reach, TouchList& out) const {
    const Vec3 way = x - at_;
    if (reach != reach_ || dot(way, way) >= far_enough * far_enough * radius * radius) {
      return false;
    }
    for (Touch touch : touches_) {
      touch.gap += dot(touch.normal, way);
      if (touch.gap < reach) {
        out.add(touch);
      }
    }
    return true;
  }

  void keep(const Vec3& x, Real reach, const TouchList& seen) {
    at_ = x, reach_ = reach;
    touches_.assign(seen.view().begin(), seen.view().end());
  }

  void forget() { reach_ = -1; }

 private:
  Vec3 at_;
  Real reach_ = -1;  ///< [m] of the search; none: -1
  std::vector<Touch> touches_;
};

}  // namespace porefines::dem
