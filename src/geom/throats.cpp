// SPDX-License-Identifier: MPL-2.0
#include <algorithm>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>

#include "geom/basins.hpp"
#include "geom/neighbours.hpp"

namespace porefines::geom {

namespace {

/// A voxel of basin `low` next to basin `high`.
struct Contact {
  std::int32_t low;
  std::int32_t high;
  Index voxel;
  float depth;  ///< [pixels] of the shallower of the two voxels

  friend bool operator<(const Contact& a, const Contact& b) {
    return std::tie(a.low, a.high, a.voxel) < std::tie(b.low, b.high, b.voxel);
  }
};

std::vector<Contact> find_contacts(const VoxelSolid& solid, const Basins& pores,
                                   const std::array<bool, 3>& periodic) {
  const Neighbours faces(solid.n, periodic, false);
  std::vector<Contact> contacts;
  for (Index v = 0; v < product(solid.n); ++v) {
    const std::int32_t here = pores.label[static_cast<std::size_t>(v)];
    if (here < 0) {
      continue;
    }
    faces.visit(v, [&](Index u) {
      const std::int32_t there = pores.label[static_cast<std::size_t>(u)];
      if (there > here) {
        contacts.push_back(
            {here, there, v,
             std::min(solid.s[static_cast<std::size_t>(v)], solid.s[static_cast<std::size_t>(u)])});
      }
    });
  }
  std::sort(contacts.begin(), contacts.end());
  return contacts;
}

/// The deepest contact of every connected patch within [first, past) of one pair of basins.
void deepest_of_patches(const std::vector<Contact>& contacts, std::size_t first, std::size_t past,
                        const Neighbours& around, std::vector<Index>& centres) {
  std::vector<std::size_t> parent(past - first);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t a) {
    while (parent[a] != a) {
      a = parent[a] = parent[parent[a]];
    }
    return a;
  };
  const auto begin = contacts.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = contacts.begin() + static_cast<std::ptrdiff_t>(past);
  for (std::size_t c = first; c < past; ++c) {
    const auto join = [&](Index u) {
      const auto found = std::lower_bound(
          begin, end, u, [](const Contact& contact, Index voxel) { return contact.voxel < voxel; });
      if (found != end && found->voxel == u) {
        parent[root(static_cast<std::size_t>(found - begin))] = root(c - first);
      }
    };
    join(contacts[c].voxel);
    around.visit(contacts[c].voxel, join);
  }
  std::vector<std::size_t> deepest(past - first, past);
  for (std::size_t c = first; c < past; ++c) {
    std::size_t& best = deepest[root(c - first)];
    if (best == past || contacts[c].depth > contacts[best].depth) {
      best = c;
    }
  }
  for (const std::size_t best : deepest) {
    if (best != past) {
      centres.push_back(contacts[best].voxel);
    }
  }
}

/// Half of the directions, evenly spread: 48 in the plane, 160 on the sphere (Fibonacci lattice).
std::vector<Vec3> half_directions(bool flat) {
  std::vector<Vec3> out;
  if (flat) {
    for (int a = 0; a < 48; ++a) {
      const Real angle = std::numbers::pi * a / 48;
      out.push_back({std::cos(angle), std::sin(angle), 0});
    }
    return out;
  }
  constexpr int count = 160;
  for (int a = 0; a < count; ++a) {
    const Real z = (a + 0.5) / count;
    const Real angle = 2 * std::numbers::pi * a / std::numbers::phi;
    const Real r = std::sqrt(1 - z * z);
    out.push_back({r * std::cos(angle), r * std::sin(angle), z});
  }
  return out;
}

/// Distance from x along e to the surface [m], at most `most`; marching by the distance itself.
Real way_to_wall(const VoxelSolid& solid, const Vec3& x, const Vec3& e, Real most) {
  const Real close = 0.01 * solid.pixel;
  Real t = 0;
  while (t < most) {
    const Real s = signed_distance(solid, x + t * e);
    if (s < close) {
      return t + s;
    }
    t += std::max(0.9 * s, 2 * close);
  }
  return most;
}

Throat measure(const VoxelSolid& solid, const Vec3& x, const std::vector<Vec3>& directions) {
  constexpr Real finest = 0.5;  // [pixels] what a voxel image can tell at all
  Throat throat{x, {1, 0, 0}, std::numeric_limits<Real>::max(), x, x};
  Real shortest = 8 * std::max(signed_distance(solid, x), solid.pixel);
  for (const Vec3& e : directions) {
    const Real ahead = way_to_wall(solid, x, e, shortest);
    if (ahead >= shortest) {
      continue;
    }
    const Real behind = way_to_wall(solid, x, -1 * e, shortest - ahead);
    if (ahead + behind < shortest) {
      shortest = ahead + behind;
      throat = {x + 0.5 * (ahead - behind) * e, e, std::max(shortest, finest * solid.pixel),
                x - behind * e, x + ahead * e};
    }
  }
  return throat;
}

}  // namespace

std::vector<Throat> find_throats(const VoxelSolid& solid, const Basins& pores,
                                 const std::array<bool, 3>& periodic) {
  const auto contacts = find_contacts(solid, pores, periodic);
  const Neighbours around(solid.n, periodic, true);
  std::vector<Index> centres;
  for (std::size_t first = 0; first < contacts.size();) {
    std::size_t past = first + 1;
    while (past < contacts.size() && contacts[past].low == contacts[first].low &&
           contacts[past].high == contacts[first].high) {
      ++past;
    }
    deepest_of_patches(contacts, first, past, around, centres);
    first = past;
  }
  const Int3 n = solid.n;
  const auto directions = half_directions(n[2] == 1);
  std::vector<Throat> throats;
  for (const Index v : centres) {
    const Int3 i{static_cast<int>(v % n[0]), static_cast<int>(v / n[0] % n[1]),
                 static_cast<int>(v / (Index{n[0]} * n[1]))};
    const Vec3 x{i[0] + 0.5, i[1] + 0.5, i[2] + 0.5};
    const Throat throat = measure(solid, solid.pixel * x, directions);
    if (throat.width < std::numeric_limits<Real>::max()) {
      throats.push_back(throat);
    }
  }
  return throats;
}

}  // namespace porefines::geom
