// SPDX-License-Identifier: MPL-2.0
#include "geom/simple_point.hpp"

#include <bit>
#include <cstdlib>

namespace porefines::geom {

namespace {

using Mask = std::uint32_t;  // one bit per voxel of the neighbourhood

constexpr int centre = 13;

struct Tables {
  std::array<Mask, 27> faces{};    ///< neighbours through a face
  std::array<Mask, 27> corners{};  ///< neighbours through a face, an edge or a corner
  Mask near18 = 0;                 ///< the centre's neighbours through faces and edges
  Mask plane = 0;                  ///< dz = 0
};

constexpr int magnitude(int a) {
  return a < 0 ? -a : a;
}

constexpr Tables make_tables() {
  Tables tables;
  for (int a = 0; a < 27; ++a) {
    for (int b = 0; b < 27; ++b) {
      const int dx = magnitude(a % 3 - b % 3);
      const int dy = magnitude(a / 3 % 3 - b / 3 % 3);
      const int dz = magnitude(a / 9 - b / 9);
      const bool adjacent = a != b && dx <= 1 && dy <= 1 && dz <= 1;
      if (adjacent && dx + dy + dz == 1) {
        tables.faces[a] |= Mask{1} << b;
      }
      if (adjacent) {
        tables.corners[a] |= Mask{1} << b;
      }
      if (a == centre && adjacent && dx + dy + dz <= 2) {
        tables.near18 |= Mask{1} << b;
      }
    }
    if (a / 9 == 1) {
      tables.plane |= Mask{1} << a;
    }
  }
  return tables;
}

constexpr Tables tables = make_tables();

/// Components of `set` under the given adjacency, counting only those that meet `touching`.
int count_components(Mask set, const std::array<Mask, 27>& adjacent, Mask touching) {
  int count = 0;
  while (set != 0) {
    Mask component = set & (~set + 1);
    for (Mask front = component; front != 0;) {
      const int v = std::countr_zero(front);
      front &= front - 1;
      const Mask fresh = adjacent[static_cast<std::size_t>(v)] & set & ~component;
      component |= fresh;
      front |= fresh;
    }
    count += (component & touching) != 0 ? 1 : 0;
    set &= ~component;
  }
  return count;
}

}  // namespace

bool is_simple(const Neighbourhood& around, bool flat) {
  Mask pore = 0;
  for (std::size_t v = 0; v < around.size(); ++v) {
    pore |= static_cast<Mask>(around[v] != 0) << v;
  }
  const Mask all = (flat ? tables.plane : (Mask{1} << 27) - 1) & ~(Mask{1} << centre);
  const Mask grain = ~pore & all;
  const Mask pore_near = pore & all & (flat ? all : tables.near18);
  return count_components(grain, tables.corners, all) == 1 &&
         count_components(pore_near, tables.faces, tables.faces[centre]) == 1;
}

}  // namespace porefines::geom
