// SPDX-License-Identifier: MPL-2.0
// Dips of one contact share its force.
#include <algorithm>

#include "dem/surface_foot.hpp"

namespace porefines::dem {

namespace {

constexpr Real least_slope = 0.1;

Real smooth_step(Real t) {
  t = std::clamp<Real>(t, 0, 1);
  return t * t * (3 - 2 * t);
}

/// Overlap of the sphere in direction `towards` (unit).
Real overlap_towards(const SurfaceSpline& spline, const Vec3& centre, Real radius,
                     const Vec3& towards) {
  const Jet jet = spline.jet(centre + radius * towards);
  return -jet.f / std::max(norm(jet.g), least_slope);
}

/// Least overlap on the arc between two feet; nothing below zero is told apart.
Real saddle(const SurfaceSpline& spline, const Vec3& centre, Real radius, const Foot& a,
            const Foot& b) {
  const auto at = [&](Real t) {
    const Vec3 towards = -1.0 * ((1 - t) * a.normal + t * b.normal);
    return overlap_towards(spline, centre, radius, towards / norm(towards));
  };
  constexpr int parts = 8;
  std::array<Real, parts + 1> c{};
  c[0] = radius - a.distance;
  c[parts] = radius - b.distance;
  int lowest = c[0] < c[parts] ? 0 : parts;
  for (int part = 1; part < parts; ++part) {
    const auto p = static_cast<std::size_t>(part);
    c[p] = at(static_cast<Real>(part) / parts);
    if (c[p] <= 0) {
      return 0;
    }
    lowest = c[p] < c[static_cast<std::size_t>(lowest)] ? part : lowest;
  }
  const auto l = static_cast<std::size_t>(lowest);
  if (lowest == 0 || lowest == parts) {
    return c[l];
  }
  // Newton's steps for the minimum of the arc's profile
  constexpr Real h = 1.0 / parts;
  Real t = lowest * h;
  Real low = c[l - 1];
  Real middle = c[l];
  Real high = c[l + 1];
  Real step = h;
  for (int i = 0; i < 3; ++i) {
    const Real curve = low - 2 * middle + high;
    t += curve > 0 ? std::clamp<Real>(-0.5 * (high - low) / curve, -1, 1) * step : 0;
    step *= 0.25;
    low = at(t - step);
    middle = at(t);
    high = at(t + step);
  }
  const Real curve = low - 2 * middle + high;
  const Real least = curve > 0 ? middle - (high - low) * (high - low) / (8 * curve) : middle;
  return std::clamp<Real>(least, 0, std::min(c[0], c[parts]));
}

struct Link {
  int a = 0;
  int b = 0;
  Real overlap = 0;  ///< at the saddle
};

}  // namespace

void share_force(const SurfaceSpline& spline, const Vec3& centre, Real radius,
                 std::span<Foot> feet) {
  share_force(feet, radius,
              [&](const Foot& a, const Foot& b) { return saddle(spline, centre, radius, a, b); });
}

void share_force(std::span<Foot> feet, Real radius, const SaddleOverlap& overlap_between) {
  constexpr Real joined = 0.8660254037844386;  // cos 30
  constexpr Real apart = 0.5;
  constexpr std::size_t most_links = 32;
  std::array<Link, most_links> link{};
  std::size_t links = 0;
  for (std::size_t a = 0; a < feet.size(); ++a) {
    for (std::size_t b = a + 1; b < feet.size(); ++b) {
      if (feet[a].distance >= radius || feet[b].distance >= radius ||
          dot(feet[a].normal, feet[b].normal) <= apart || links == most_links) {
        continue;
      }
      const Real overlap = overlap_between(feet[a], feet[b]);
      if (overlap > 0) {
        link[links++] = {static_cast<int>(a), static_cast<int>(b), overlap};
      }
    }
  }
  std::stable_sort(link.begin(), link.begin() + static_cast<std::ptrdiff_t>(links),
                   [](const Link& l, const Link& r) { return l.overlap > r.overlap; });
  std::array<int, 64> tree{};
  for (std::size_t f = 0; f < tree.size(); ++f) {
    tree[f] = static_cast<int>(f);
  }
  for (std::size_t l = 0; l < links; ++l) {
    Foot& a = feet[static_cast<std::size_t>(link[l].a)];
    Foot& b = feet[static_cast<std::size_t>(link[l].b)];
    const int keep = tree[static_cast<std::size_t>(link[l].a)];
    const int join = tree[static_cast<std::size_t>(link[l].b)];
    if (keep == join) {
      continue;
    }
    std::replace(tree.begin(), tree.end(), join, keep);
    const Real ea = radius - a.distance - link[l].overlap;
    const Real eb = radius - b.distance - link[l].overlap;
    const Real to_a = ea + eb > 0 ? eb / (ea + eb) : 0.5;
    const Real near = smooth_step((dot(a.normal, b.normal) - apart) / (joined - apart));
    const auto part = [&](const Foot& foot) {
      return near * std::pow(link[l].overlap / (radius - foot.distance), 1.5);
    };
    a.share -= to_a * part(a);
    b.share -= (1 - to_a) * part(b);
  }
  for (Foot& foot : feet) {
    foot.share = std::max<Real>(foot.share, 0);
  }
}

}  // namespace porefines::dem
