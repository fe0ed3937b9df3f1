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

/// bending() of a surface that does not vary along z.
Bending bending_across(const Jet& jet) {
  Bending out;
  out.slope = std::sqrt(jet.g.x * jet.g.x + jet.g.y * jet.g.y);
  if (out.slope == 0) {
    return out;
  }
  const Real inverse = 1 / out.slope;
  out.n = {inverse * jet.g.x, inverse * jet.g.y, 0};
  out.u = {out.n.y, -out.n.x, 0};
  out.v = {0, 0, -1};
  const Real along = out.u.x * (jet.xx * out.u.x + 2 * jet.xy * out.u.y);
  out.uu = inverse * (along + jet.yy * out.u.y * out.u.y);
  return out;
}

constexpr Real least_stretch = 0.02;

/// tangential_step on such a surface.
Step step_across(const Bending& b, Real d, const Vec3& e, Real longest) {
  const Real t = dot(e, b.u) / std::max(std::abs(1 + d * b.uu), least_stretch);
  const Real tu = std::clamp(t, -longest, longest);
  return {tu * b.u, 0.5 * b.uu * tu * tu};
}

Step tangential_step(const Bending& b, Real d, const Vec3& e, Real longest) {
  constexpr Real least = least_stretch;
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
    const Bending here = spline.flat ? bending_across(jet) : bending(jet);
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
    const Vec3 e = from - d * b.n;
    off = norm(e);
    step = spline.flat ? step_across(b, d, e, longest) : tangential_step(b, d, e, longest);
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
