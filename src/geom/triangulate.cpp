// SPDX-License-Identifier: MPL-2.0
#include "geom/triangulate.hpp"

#include <algorithm>
#include <limits>

namespace porefines::geom {

namespace {

Real turn(const Point2& a, const Point2& b, const Point2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool inside(const Outline& outline, const Point2& p) {
  bool in = false;
  for (std::size_t a = 0; a < outline.size(); ++a) {
    const Point2& u = outline[a];
    const Point2& v = outline[(a + 1) % outline.size()];
    if ((u[1] > p[1]) != (v[1] > p[1]) &&
        p[0] < u[0] + (p[1] - u[1]) / (v[1] - u[1]) * (v[0] - u[0])) {
      in = !in;
    }
  }
  return in;
}

class Polygon {
 public:
  Polygon(const std::vector<Outline>& outlines, std::int32_t outer) : outlines_(outlines) {
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(at(outer).size()); ++i) {
      ring_.push_back({outer, i});
    }
  }

  [[nodiscard]] const Point2& point(const Corner& c) const {
    return at(c.outline)[static_cast<std::size_t>(c.place)];
  }

  /// Bridge from the rightmost point of the hole to a ring corner that it sees (Eberly 2002).
  void join_hole(std::int32_t hole) {
    const Outline& points = at(hole);
    const auto rightmost = std::max_element(points.begin(), points.end());
    const auto from = static_cast<std::int32_t>(rightmost - points.begin());
    const std::size_t to = visible_corner(*rightmost);
    std::vector<Corner> bridged;
    const auto count = static_cast<std::int32_t>(points.size());
    for (std::int32_t i = 0; i <= count; ++i) {
      bridged.push_back({hole, (from + i) % count});
    }
    bridged.push_back(ring_[to]);
    ring_.insert(ring_.begin() + static_cast<std::ptrdiff_t>(to) + 1, bridged.begin(),
                 bridged.end());
  }

  void clip_ears(std::vector<std::array<Corner, 3>>& triangles) {
    std::size_t at_corner = 0;
    std::size_t tried = 0;
    while (ring_.size() > 3) {
      const std::size_t n = ring_.size();
      const std::size_t b = at_corner % n;
      const std::size_t a = (b + n - 1) % n;
      const std::size_t c = (b + 1) % n;
      // after a whole round without an ear (rounding) the next corner is cut off regardless
      if (tried < n && !is_ear(a, b, c)) {
        at_corner = c;
        ++tried;
        continue;
      }
      triangles.push_back({ring_[a], ring_[b], ring_[c]});
      ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(b));
      at_corner = b % ring_.size();
      tried = 0;
    }
    triangles.push_back({ring_[0], ring_[1], ring_[2]});
  }

 private:
  [[nodiscard]] const Outline& at(std::int32_t outline) const {
    return outlines_[static_cast<std::size_t>(outline)];
  }

  [[nodiscard]] std::size_t visible_corner(const Point2& m) const {
    const std::size_t n = ring_.size();
    std::size_t best = 0;
    Real nearest = std::numeric_limits<Real>::max();
    Point2 hit = m;
    for (std::size_t a = 0; a < n; ++a) {  // ray from m towards +x
      const Point2& p = point(ring_[a]);
      const Point2& q = point(ring_[(a + 1) % n]);
      if (p[1] > m[1] || q[1] < m[1] || p[1] == q[1]) {
        continue;  // only upward segments have the area on their left, where m is
      }
      const Real x = p[0] + (m[1] - p[1]) / (q[1] - p[1]) * (q[0] - p[0]);
      if (x >= m[0] && x - m[0] < nearest) {
        nearest = x - m[0];
        best = p[0] > q[0] ? a : (a + 1) % n;
        hit = {x, m[1]};
      }
    }
    // a corner inside the triangle (m, hit, best) hides it: take the one nearest to the ray
    const Point2 corner = point(ring_[best]);
    const bool above = corner[1] > m[1];
    Real steepest = std::numeric_limits<Real>::max();
    std::size_t chosen = best;
    for (std::size_t a = 0; a < n; ++a) {
      const Point2& p = point(ring_[a]);
      const Point2& prior = point(ring_[(a + n - 1) % n]);
      const Point2& after = point(ring_[(a + 1) % n]);
      const bool within =
          above ? turn(m, hit, p) >= 0 && turn(hit, corner, p) >= 0 && turn(corner, m, p) >= 0
                : turn(m, p, hit) >= 0 && turn(hit, p, corner) >= 0 && turn(corner, p, m) >= 0;
      if (!within || p[0] <= m[0] || (p == corner && a != best) || turn(prior, p, after) > 0) {
        continue;
      }
      const Real slope = std::abs(p[1] - m[1]) / (p[0] - m[0]);
      if (slope < steepest) {
        steepest = slope;
        chosen = a;
      }
    }
    return chosen;
  }

  [[nodiscard]] bool is_ear(std::size_t a, std::size_t b, std::size_t c) const {
    const Point2& p = point(ring_[a]);
    const Point2& q = point(ring_[b]);
    const Point2& r = point(ring_[c]);
    if (turn(p, q, r) <= 0) {
      return false;
    }
    const auto [left, right] = std::minmax({p[0], q[0], r[0]});
    const auto [low, high] = std::minmax({p[1], q[1], r[1]});
    for (const Corner& corner : ring_) {
      const Point2& x = point(corner);
      if (x[0] < left || x[0] > right || x[1] < low || x[1] > high || x == p || x == q || x == r) {
        continue;
      }
      if (turn(p, q, x) >= 0 && turn(q, r, x) >= 0 && turn(r, p, x) >= 0) {
        return false;
      }
    }
    return true;
  }

  const std::vector<Outline>& outlines_;
  std::vector<Corner> ring_;
};

}  // namespace

std::vector<std::array<Corner, 3>> triangulate(const std::vector<Outline>& outlines) {
  const auto count = static_cast<std::int32_t>(outlines.size());
  std::vector<Real> area(outlines.size());
  std::vector<std::vector<std::int32_t>> holes(outlines.size());
  for (std::size_t o = 0; o < outlines.size(); ++o) {
    area[o] = signed_area(outlines[o]);
  }
  for (std::int32_t hole = 0; hole < count; ++hole) {
    const auto h = static_cast<std::size_t>(hole);
    std::int32_t around = -1;  // the smallest outer outline that holds the hole
    for (std::int32_t outer = 0; area[h] < 0 && outer < count; ++outer) {
      const auto o = static_cast<std::size_t>(outer);
      if (area[o] > -area[h] && inside(outlines[o], outlines[h][0]) &&
          (around < 0 || area[o] < area[static_cast<std::size_t>(around)])) {
        around = outer;
      }
    }
    if (around >= 0) {
      holes[static_cast<std::size_t>(around)].push_back(hole);
    }
  }
  std::vector<std::array<Corner, 3>> triangles;
  for (std::int32_t outer = 0; outer < count; ++outer) {
    const auto o = static_cast<std::size_t>(outer);
    if (area[o] < 0) {
      continue;
    }
    // from right to left, so that earlier bridges cannot cut off later holes
    std::sort(holes[o].begin(), holes[o].end(), [&](std::int32_t a, std::int32_t b) {
      const auto& p = outlines[static_cast<std::size_t>(a)];
      const auto& q = outlines[static_cast<std::size_t>(b)];
      return *std::max_element(p.begin(), p.end()) > *std::max_element(q.begin(), q.end());
    });
    Polygon polygon(outlines, outer);
    for (const std::int32_t hole : holes[o]) {
      polygon.join_hole(hole);
    }
    polygon.clip_ears(triangles);
  }
  return triangles;
}

}  // namespace porefines::geom
