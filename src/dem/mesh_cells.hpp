// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <algorithm>

#include "dem/mesh.hpp"

namespace porefines::dem {

struct CellBox {
  Vec3 low;
  Vec3 high;
};

struct CellRange {
  Int3 low{};
  Int3 high{};  ///< inclusive

  template <class Visit>
  void for_each(const Visit& visit) const {
    for (int k = low[2]; k <= high[2]; ++k) {
      for (int j = low[1]; j <= high[1]; ++j) {
        for (int i = low[0]; i <= high[0]; ++i) {
          visit(Int3{i, j, k});
        }
      }
    }
  }
};

[[nodiscard]] inline const Vec3& corner(const Mesh& mesh, std::size_t face, std::size_t k) {
  return mesh.vertex[static_cast<std::size_t>(mesh.face[face][k])];
}

[[nodiscard]] inline CellBox face_box(const Mesh& mesh, std::size_t face) {
  CellBox box{corner(mesh, face, 0), corner(mesh, face, 0)};
  for (std::size_t k = 1; k < 3; ++k) {
    for (int a = 0; a < 3; ++a) {
      box.low[a] = std::min(box.low[a], corner(mesh, face, k)[a]);
      box.high[a] = std::max(box.high[a], corner(mesh, face, k)[a]);
    }
  }
  return box;
}

/// Cells that a box meets; empty (low > high) beyond the grid.
[[nodiscard]] inline CellRange cells_of(const Mesh& mesh, const CellBox& box) {
  CellRange out;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const Real last = mesh.cells[a];
    const auto cell = [&](Real x) {
      return static_cast<int>(
          std::floor(std::clamp<Real>((x - mesh.low[axis]) / mesh.cell, -1, last)));
    };
    out.low[a] = std::max(cell(box.low[axis]), 0);
    out.high[a] = std::min(cell(box.high[axis]), mesh.cells[a] - 1);
  }
  return out;
}

[[nodiscard]] inline std::size_t cell_index(const Mesh& mesh, const Int3& c) {
  return static_cast<std::size_t>(c[0] +
                                  Index{mesh.cells[0]} * (c[1] + Index{mesh.cells[1]} * c[2]));
}

}  // namespace porefines::dem
