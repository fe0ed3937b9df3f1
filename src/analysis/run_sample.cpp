// SPDX-License-Identifier: MPL-2.0
#include "analysis/run_sample.hpp"

namespace porefines::analysis {

WallTouch touch_wall(const std::function<Real(const Vec3&)>& signed_distance, const Vec3& x,
                     Real radius) {
  WallTouch touch{signed_distance(x) - radius, {}};
  const Real step = 0.05 * radius;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 ahead = x;
    Vec3 behind = x;
    ahead[axis] += step;
    behind[axis] -= step;
    touch.normal[axis] = signed_distance(ahead) - signed_distance(behind);
  }
  const Real length = norm(touch.normal);
  touch.normal *= length > 0.1 * step ? 1 / length : 0;
  return touch;
}

const char* name_of(Fate fate) {
  switch (fate) {
    case Fate::piping:
      return "piping";
    case Fate::bridging:
      return "bridging";
    case Fate::clogged:
      return "clogged";
    case Fate::resting:
      break;
  }
  return "resting";
}

}  // namespace porefines::analysis
