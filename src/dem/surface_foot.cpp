// SPDX-License-Identifier: MPL-2.0
#include "dem/surface_foot.hpp"

#include <algorithm>
#include <limits>

#include "dem/surface_points.hpp"

namespace porefines::dem {

namespace {

constexpr int most_steps = 30;
constexpr Real longest_step = 0.7;  // [voxels]
constexpr Real settled = 3e-5;      // [voxels] of the last step; the distance is then right to 1e-9
constexpr Real nearly_settled = 0.02;  // [voxels] of the tangential offset
constexpr Real on_surface = 1e-3;      // [voxels] good enough where the last steps did not settle
constexpr Real joins = 0.4;            // [voxels] from a known foot
constexpr Real least_slope = 0.1;

/// Tangential step of (I + d S) t = e with |eigenvalues|, at least `least`: always downhill.
struct Step {
  Vec3 t;
  Real bent = 0;  ///< t.S t / 2
};

Step tangential_step(const Bending& b, Real d, const Vec3& e, Real longest) {
  constexpr Real least = 0.02;
  const Real eu = dot(e, b.u);
  const Real ev = dot(e, b.v);
  const Real mean = 1 + 0.5 * d * (b.uu + b.vv);
  const Real half = 0.5 * d * (b.uu - b.vv);
  const Real off = d * b.uv;
  const Real spread = std::sqrt(half * half + off * off);
  const Real high = std::max(std::abs(mean + spread), least);
  const Real low = std::max(std::abs(mean - spread), least);
  // inverse = p I + q (M - mean I) / spread on the eigenvectors of M
  const Real p = 0.5 * (1 / high + 1 / low);
  const Real q = spread > 0 ? 0.5 * (1 / high - 1 / low) / spread : 0;
  Real tu = p * eu + q * (half * eu + off * ev);
  Real tv = p * ev + q * (off * eu - half * ev);
  const Real length = std::sqrt(tu * tu + tv * tv);
  const Real scale = length > longest ? longest / length : 1;
  tu *= scale;
  tv *= scale;
  return {tu * b.u + tv * b.v, 0.5 * (b.uu * tu * tu + 2 * b.uv * tu * tv + b.vv * tv * tv)};
}

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

Foot find_foot(const SurfaceSpline& spline, const Vec3& centre, const Vec3& start,
               std::span<const Foot> known) {
  Foot out;
  Vec3 x = start;
  Vec3 best = start;
  Bending b;
  Step step;
  Real least = std::numeric_limits<Real>::max();
  Real longest = longest_step;
  Real off = 0;  // tangential offset
  for (int count = 0; count < most_steps; ++count) {
    const Jet jet = spline.jet(x);
    const Bending here = bending(jet);
    if (here.slope < least_slope) {
      return out;
    }
    const Real residual = std::clamp(jet.f / here.slope, -longest_step, longest_step);
    x -= residual * here.n;
    const Vec3 away = centre - x;
    const Real square = dot(away, away);
    if (square > least * (1 + 1e-14) && longest > settled) {  // uphill: shorter from the best
      longest = 0.25 * std::min(norm(step.t), longest);
    } else {
      best = x;
      least = square;
      b = here;
      longest = std::min(2 * longest, longest_step);
      out.found = std::abs(residual) < on_surface;
    }
    const Vec3 from = centre - best;
    const Real d = dot(from, b.n);
    off = norm(from - d * b.n);
    step = tangential_step(b, d, from - d * b.n, longest);
    x = best + step.t - step.bent * b.n;
    for (const Foot& foot : known) {
      const Vec3 apart = x - foot.at;
      if (dot(apart, apart) < joins * joins) {
        out.found = false;
        return out;
      }
    }
    if (dot(step.t, step.t) < settled * settled && std::abs(residual) < settled) {
      best = x;
      break;
    }
  }
  const Vec3 away = centre - best;
  const Real length = norm(away);
  const Real side = dot(away, b.n) < 0 ? -1 : 1;
  out.found = out.found && off < nearly_settled;
  out.at = best;
  out.distance = side * length;
  out.normal = length > 1e-6 ? (side / length) * away : b.n;
  return out;
}

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

std::span<Foot> keep_near_side(std::span<Foot> feet, Real within) {
  std::sort(feet.begin(), feet.end(), [](const Foot& a, const Foot& b) {
    return std::abs(a.distance) < std::abs(b.distance);
  });
  if (!feet.empty() && feet[0].distance <= 0) {
    return feet.first(1);
  }
  const auto past = std::remove_if(feet.begin(), feet.end(), [&](const Foot& foot) {
    return foot.distance <= 0 || foot.distance >= within;
  });
  return feet.first(static_cast<std::size_t>(past - feet.begin()));
}

}  // namespace porefines::dem
