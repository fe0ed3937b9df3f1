// SPDX-License-Identifier: MPL-2.0
// A throat followed along its normal: where it is narrowest, which way it goes, how far it reaches.
#include <algorithm>

#include "geom/throat_shape.hpp"

namespace porefines::geom {

namespace {

constexpr Real wider = 1.25;  ///< gap over width where a throat ends
constexpr Real longest = 6;   ///< widths that a throat reaches to either side

}  // namespace

std::vector<ThroatShape::Gap> ThroatShape::gaps(const Throat& throat, Real sign) const {
  const Real step = std::max(0.5 * solid_.pixel, throat.width / 16);
  const Real most = wider * throat.width;
  std::vector<Gap> out;
  Vec3 x = throat.centre;
  const int steps = static_cast<int>(longest * throat.width / step);
  for (int n = 1; n <= steps; ++n) {
    const Real gone = n * step;
    x += sign * step * throat.normal;
    if (frame_.distance(x) <= 0) {
      return out;
    }
    const Real up = way_to_wall(x, throat.across, most);
    const Real down = way_to_wall(x, -1 * throat.across, most);
    if (up + down >= most) {
      out.push_back({x, up + down, gone});
      return out;
    }
    x += 0.5 * (up - down) * throat.across;
    out.push_back({x, up + down, gone});
  }
  return out;
}

Real ThroatShape::extent(const Throat& throat, Real sign) const {
  Real gone = 0;
  for (const Gap& gap : gaps(throat, sign)) {
    gone = gap.width < wider * throat.width ? gap.gone : gone;
  }
  return gone;
}

/// The watershed meets near the saddle of the distance, not on it; in a channel anywhere.
Vec3 ThroatShape::middle_of_narrowest(const Throat& throat) const {
  std::vector<Gap> line = gaps(throat, -1);
  std::reverse(line.begin(), line.end());
  line.push_back({throat.centre, throat.width, 0});
  const auto ahead = gaps(throat, 1);
  line.insert(line.end(), ahead.begin(), ahead.end());
  const auto least = std::min_element(line.begin(), line.end(),
                                      [](const Gap& a, const Gap& b) { return a.width < b.width; });
  // walls drawn in pixels: the gap of a slanted channel varies by 0.64 pixels in the test
  const Real ripple = std::max(0.7 * solid_.pixel, 0.02 * throat.width);
  const auto beyond = [&](const Gap& gap) { return gap.width > least->width + ripple; };
  const auto last = std::find_if(least, line.end(), beyond);
  const auto first = std::find_if(std::make_reverse_iterator(least), line.rend(), beyond).base();
  // a gap that does not open again ends in a cleft where grains meet, or the line was cut short
  const bool opens = first != line.begin() && last != line.end();
  return opens ? (first + (last - 1 - first) / 2)->middle : throat.centre;
}

/// In 2D a chord from pixel corner to pixel corner may lean; the middle of the gap, a width to both
/// sides, does not.
void ThroatShape::follow_middle(Throat& throat) const {
  const auto at_a_width = [&](Real sign) {
    Vec3 x = throat.centre;
    for (const Gap& gap : gaps(throat, sign)) {
      x = gap.gone <= throat.width ? gap.middle : x;
    }
    return x;
  };
  const Vec3 along = at_a_width(1) - at_a_width(-1);
  if (flat_ && norm(along) > throat.width) {
    throat.normal = along / norm(along);
    throat.across = {-throat.normal.y, throat.normal.x, 0};
  }
}

}  // namespace porefines::geom
