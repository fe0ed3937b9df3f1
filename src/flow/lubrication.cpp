// SPDX-License-Identifier: MPL-2.0
#include "flow/lubrication.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace porefines::flow {

namespace {

using std::numbers::pi;

constexpr Real shear_length = 0.373;  ///< cells

/// Share of 1/g that the grid resolves. Means of D = 6, 8 and 12 against Brenner (1961) and Stimson & Jeffery (1926);
/// between two spheres also over places and directions, which scatter by a quarter below half a cell.
struct Resolved {
  Real gap;  ///< cells
  Real wall;
  Real pair;
};
constexpr std::array<Resolved, 17> resolved{{{0, 0, 0},
                                             {0.05, 0.135, 0.175},
                                             {0.1, 0.265, 0.32},
                                             {0.15, 0.375, 0.45},
                                             {0.2, 0.458, 0.56},
                                             {0.25, 0.541, 0.6375},
                                             {0.3, 0.587, 0.69},
                                             {0.35, 0.63, 0.7175},
                                             {0.425, 0.695, 0.785},
                                             {0.5, 0.725, 0.84},
                                             {0.625, 0.8055, 0.881},
                                             {0.75, 0.866, 0.9225},
                                             {0.875, 0.927, 0.932},
                                             {1, 0.96, 0.941},
                                             {1.25, 0.976, 0.9625},
                                             {1.5, 0.969, 0.979},
                                             {lubrication_range, 1, 1}}};

Vec3 linear(const Six& v) {
  return {v[0], v[1], v[2]};
}
Vec3 angular(const Six& v) {
  return {v[3], v[4], v[5]};
}
Vec3 across(const Vec3& v, const Vec3& n) {
  return v - dot(v, n) * n;
}
void put(const Vec3& force, const Vec3& torque, Real factor, Six& out) {
  for (int a = 0; a < 3; ++a) {
    out[a] += factor * force[a];
    out[3 + a] += factor * torque[a];
  }
}

/// Forces and torques on both for motions v and w (w: zero at a wall).
struct Pull {
  Vec3 force_first, torque_first, force_second, torque_second;
};

Pull pull_of(const Lubrication& q, const Six& v, const Six& w) {
  const Vec3& n = q.normal;
  const Real a = q.radius_first;
  const Real b = q.radius_second;
  const Vec3 squeeze = -q.squeeze * dot(linear(v) - linear(w), n) * n;
  const Vec3 slip =
      across(linear(v) - a * cross(angular(v), n) - linear(w) - b * cross(angular(w), n), n);
  Pull out;
  if (q.second < 0) {
    const Vec3 drag = -0.8 * q.shear * slip;
    out.force_first = squeeze + drag - 2.4 * q.shear * across(linear(v), n);
    out.torque_first = cross(-a * n, drag) - 2.4 * q.shear * a * a * across(angular(v), n);
    return out;
  }
  const Vec3 drag = -q.shear * slip;
  const Real mean = 2 * a * b / (a + b);
  const Vec3 twist = -0.6 * q.shear * mean * mean * across(angular(v) - angular(w), n);
  out.force_first = squeeze + drag;
  out.torque_first = cross(-a * n, drag) + twist;
  out.force_second = Vec3{} - squeeze - drag;
  out.torque_second = cross(b * n, Vec3{} - drag) - twist;
  return out;
}

Lubrication make(int first, int second, const Vec3& normal, Real gap, Real a, Real b,
                 Real roughness) {
  const Real least = roughness > 0 ? roughness : 0.01 * std::min(a, b > 0 ? b : a);
  const Real g = std::max(gap, least);
  const Real reduced = second < 0 ? a : a * b / (a + b);
  const Real log = g < shear_length ? std::log(shear_length / g) : 0;
  return {first,
          second,
          normal,
          a,
          second < 0 ? 0 : b,
          6 * pi * reduced * reduced * missing_squeeze(g, second < 0),
          pi * (second < 0 ? a : 2 * reduced) * log,
          gap,
          least,
          gap < 0};
}

/// Calls visit(later image, earlier image) for pairs whose surfaces may be within lubrication_range:
/// those in the same or in neighbouring cells of a table that is wide enough.
template <typename Visit>
void for_near_pairs(const SphereSet& set, const Visit& visit) {
  constexpr std::int64_t span = 1 << 20;
  Real largest = 0;
  for (const Ball& ball : set.balls()) {
    largest = std::max(largest, ball.body);
  }
  const Real width = 2 * largest + lubrication_range;
  const auto key_of = [&](const Vec3& x, std::int64_t i, std::int64_t j, std::int64_t k) {
    const auto cell = [&](Real c) { return static_cast<std::int64_t>(std::floor(c / width)); };
    return (cell(x.x) + i + span / 2) +
           span * ((cell(x.y) + j + span / 2) + span * (cell(x.z) + k + span / 2));
  };
  std::unordered_map<std::int64_t, std::vector<const BallImage*>> table;
  for (const BallImage& image : set.images()) {
    for (int near = 0; near < 27; ++near) {
      const auto found =
          table.find(key_of(image.centre, near % 3 - 1, near / 3 % 3 - 1, near / 9 - 1));
      if (found == table.end()) {
        continue;
      }
      for (const BallImage* other : found->second) {
        visit(image, *other);
      }
    }
    table[key_of(image.centre, 0, 0, 0)].push_back(&image);
  }
}

}  // namespace

Real missing_squeeze(Real gap, bool wall) {
  if (gap >= lubrication_range) {
    return 0;
  }
  std::size_t k = 1;
  while (k + 1 < resolved.size() && gap > resolved[k].gap) {
    ++k;
  }
  const Resolved& low = resolved[k - 1];
  const Resolved& high = resolved[k];
  const Real t = (gap - low.gap) / (high.gap - low.gap);
  const Real share =
      wall ? low.wall + t * (high.wall - low.wall) : low.pair + t * (high.pair - low.pair);
  return std::max((1 - share) / gap, 0.0);
}

std::vector<Lubrication> find_lubrication(const SphereSet& set, const grid::Block& block,
                                          std::span<const WallGap> walls, Real roughness) {
  std::vector<Lubrication> out;
  for (const WallGap& q : walls) {
    if (q.gap < lubrication_range) {
      out.push_back(make(static_cast<int>(q.sphere), -1, q.normal, q.gap,
                         set.balls()[q.sphere].body, 0, roughness));
      out.back().squeeze *= q.share;
      out.back().shear *= q.share;
    }
  }
  const auto counted = [&](const Vec3& x) {
    for (int a = 0; a < 3; ++a) {
      const Real i = x[a] / set.spacing()[a] - block.start[a];
      if (i < 0 || i >= block.n[a]) {
        return false;
      }
    }
    return true;
  };
  for_near_pairs(set, [&](const BallImage& p, const BallImage& q) {
    const Real a = set.balls()[p.ball].body;
    const Real b = set.balls()[q.ball].body;
    const Vec3 d = p.centre - q.centre;
    const Real distance = norm(d);
    const Real gap = distance - a - b;
    if (p.ball == q.ball || gap >= lubrication_range || distance == 0) {
      return;
    }
    const Vec3 n = d / distance;
    if (counted(q.centre + (b + gap / 2) * n)) {
      out.push_back(make(p.ball, q.ball, n, gap, a, b, roughness));
    }
  });
  return out;
}

void add_lubrication(const Lubrication& gap, const std::vector<Six>& motion, Real factor,
                     std::vector<Six>& force) {
  const Pull pull = pull_of(gap, motion[gap.first], gap.second < 0 ? Six{} : motion[gap.second]);
  put(pull.force_first, pull.torque_first, factor, force[gap.first]);
  if (gap.second >= 0) {
    put(pull.force_second, pull.torque_second, factor, force[gap.second]);
  }
}

void add_contact(const Lubrication& gap, const std::vector<Six>& motion, Real factor,
                 std::vector<Six>& force) {
  const Vec3 second = gap.second < 0 ? Vec3{} : linear(motion[gap.second]);
  const Real closing = -dot(linear(motion[gap.first]) - second, gap.normal);
  if (!gap.touching || closing <= 0) {
    return;
  }
  const Vec3 push = gap.squeeze * closing * gap.normal;
  put(push, {}, factor, force[gap.first]);
  if (gap.second >= 0) {
    put(Vec3{} - push, {}, factor, force[gap.second]);
  }
}

void add_own_blocks(const Lubrication& gap, Real factor, std::vector<SixBySix>& blocks) {
  for (std::size_t x = 0; x < 6; ++x) {
    Six unit{};
    unit[x] = 1;
    const Pull own = pull_of(gap, unit, {});
    Six column{};
    put(own.force_first, own.torque_first, -factor, column);
    for (std::size_t y = 0; y < 6; ++y) {
      blocks[gap.first][6 * y + x] += column[y];
    }
    if (gap.second >= 0) {
      const Pull other = pull_of(gap, {}, unit);
      column.fill(0);
      put(other.force_second, other.torque_second, -factor, column);
      for (std::size_t y = 0; y < 6; ++y) {
        blocks[gap.second][6 * y + x] += column[y];
      }
    }
  }
}

}  // namespace porefines::flow
