// SPDX-License-Identifier: MPL-2.0
#include <algorithm>
#include <numeric>
#include <tuple>

#include "geom/basins.hpp"
#include "geom/neighbours.hpp"
#include "geom/thinning.hpp"
#include "geom/throat_shape.hpp"

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
                        const Neighbours& around, std::vector<Contact>& centres) {
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
      centres.push_back(contacts[best]);
    }
  }
}

}  // namespace

std::vector<Throat> find_throats(const VoxelSolid& solid, const Basins& pores,
                                 const std::array<bool, 3>& periodic, const ThroatFrame& frame) {
  const auto contacts = find_contacts(solid, pores, periodic);
  const Neighbours around(solid.n, periodic, true);
  std::vector<Contact> centres;
  for (std::size_t first = 0; first < contacts.size();) {
    std::size_t past = first + 1;
    while (past < contacts.size() && contacts[past].low == contacts[first].low &&
           contacts[past].high == contacts[first].high) {
      ++past;
    }
    deepest_of_patches(contacts, first, past, around, centres);
    first = past;
  }
  const ThroatShape shape(solid, pores, periodic, frame);
  std::vector<Throat> throats;
  for (const Contact& contact : centres) {
    const Int3 i = position(solid.n, contact.voxel);
    const Vec3 x = solid.pixel * Vec3{i[0] + 0.5, i[1] + 0.5, i[2] + 0.5};
    if (const auto throat = shape.measure(x, contact.low, contact.high)) {
      throats.push_back(*throat);
    }
  }
  std::stable_sort(throats.begin(), throats.end(), [](const Throat& a, const Throat& b) {
    return std::tie(a.centre.x, a.centre.y, a.centre.z) <
           std::tie(b.centre.x, b.centre.y, b.centre.z);
  });
  return throats;
}

}  // namespace porefines::geom
