// SPDX-License-Identifier: MPL-2.0
#include "surface/landmarks.hpp"

#include <cmath>
#include <vector>

namespace porefines::surface {
namespace {

constexpr Real nearest = 1e-16;      ///< [m]
constexpr Real debye_lengths = 100;  ///< the farthest gap
constexpr Real gaps_a_decade = 200;

struct Crossing {
  Real gap;
  bool falling;  ///< from positive to negative with the gap
};

template <typename Function>
Real bisect(const Function& f, Real low, Real high) {
  const bool positive = f(low) > 0;
  for (int i = 0; i < 60; ++i) {
    const Real middle = 0.5 * (low + high);
    ((f(middle) > 0) == positive ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Zeros of f, the nearest first. Where f vanishes altogether (beyond the reach of every law) it has none.
template <typename Function>
std::vector<Crossing> crossings(const Function& f, Real low, Real high) {
  std::vector<Crossing> found;
  Real before = low;
  Real value = f(low);
  const int count = static_cast<int>(gaps_a_decade * std::log10(high / low));
  for (int i = 1; i <= count; ++i) {
    const Real h = low * std::pow(10.0, i / gaps_a_decade);
    const Real here = f(h);
    if (here == 0) {
      continue;
    }
    if (value != 0 && (value > 0) != (here > 0)) {
      found.push_back({bisect(f, before, h), here < 0});
    }
    before = h;
    value = here;
  }
  return found;
}

/// A minimum at a gap: the pull is greatest where the stiffness vanishes on the way out.
Well well_at(const ForceLaw& law, Real radius, Real gap, Real farthest) {
  Well well{.gap = gap, .energy = radius * law.energy(gap)};
  for (const Crossing& c :
       crossings([&](Real h) { return law.push(h).stiffness; }, gap, farthest)) {
    if (c.falling) {
      well.pull_gap = c.gap;
      well.pull = -radius * law.push(c.gap).force;
      break;
    }
  }
  return well;
}

/// sigma, out of A/6 and A sigma^6/1260
Real born_diameter(const ForceLaw& law) {
  return law.born.strength > 0
             ? std::pow(210 * law.born.strength / law.attraction.strength, 1.0 / 6)
             : 0;
}

}  // namespace

Landmarks find_landmarks(const ForceLaw& law, Real radius) {
  const Real farthest = debye_lengths / law.layers.kappa;
  const std::vector<Crossing> extrema =
      crossings([&](Real h) { return law.push(h).force; }, nearest, farthest);
  Landmarks marks;
  for (const Crossing& c : extrema) {
    if (!c.falling) {
      marks.barrier = Barrier{c.gap, radius * law.energy(c.gap)};
    }
  }
  const Real divide = marks.barrier ? marks.barrier->gap : born_diameter(law);
  for (const Crossing& c : extrema) {
    if (c.falling) {
      (c.gap < divide ? marks.primary : marks.secondary) = well_at(law, radius, c.gap, farthest);
    }
  }
  return marks;
}

}  // namespace porefines::surface
