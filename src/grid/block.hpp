// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstddef>

#include "core/types.hpp"
#include "par/decomposition.hpp"

namespace porefines::grid {

/// Cells of one vector line: 16 floats fill a cache line and an AVX-512 register.
inline constexpr int line_width = 16;

/// What one rank holds of a staggered (MAC) grid: its cells, ghosts around them, memory layout.
///
/// Local cell indices run over [0, n); face i of an axis lies on the low side of cell i. Every
/// field, on cells or faces, has the same shape [-ghost, n + ghost] along each axis: where the
/// block ends at a non-periodic boundary, face n is that boundary. Memory runs along x; rows are
/// padded to whole lines of 16 values, the first of which starts at x index -ghost[0].
struct Block {
  Int3 global{1, 1, 1};            ///< cells of the whole grid
  Int3 start{0, 0, 0};             ///< global index of local cell 0
  Int3 n{1, 1, 1};                 ///< cells owned
  Int3 ghost{1, 1, 1};             ///< ghost layers
  std::array<bool, 3> owns_end{};  ///< owns face n: the block ends at a non-periodic boundary
  std::ptrdiff_t sy = 0;           ///< memory stride of y
  std::ptrdiff_t sz = 0;           ///< memory stride of z
  std::ptrdiff_t origin = 0;       ///< memory position of cell (0, 0, 0)
  std::size_t size = 0;            ///< values per field

  [[nodiscard]] std::ptrdiff_t at(int i, int j, int k) const {
    return origin + i + sy * j + sz * k;
  }
  /// The inverse of at().
  [[nodiscard]] Int3 index_of(std::ptrdiff_t position) const {
    const std::ptrdiff_t from = position - at(-ghost[0], -ghost[1], -ghost[2]);
    return {static_cast<int>(from % sy) - ghost[0], static_cast<int>(from % sz / sy) - ghost[1],
            static_cast<int>(from / sz) - ghost[2]};
  }
  /// Where a face of an axis (component 0, 1, 2) or a cell (3) has its centre [cells from the corner
  /// of the grid].
  [[nodiscard]] Vec3 centre(int component, const Int3& index) const {
    Vec3 x;
    for (int a = 0; a < 3; ++a) {
      x[a] = index[a] + start[a] + (a == component ? 0.0 : 0.5);
    }
    return x;
  }
  [[nodiscard]] std::ptrdiff_t stride(int axis) const {
    return axis == 0 ? 1 : axis == 1 ? sy : sz;
  }
  [[nodiscard]] int lines() const { return static_cast<int>(sy / line_width); }
  /// Parity (0 or 1) of local index sum (i + j + k) = 0 in global indices: colours agree across ranks.
  [[nodiscard]] int parity() const { return (start[0] + start[1] + start[2]) & 1; }
  [[nodiscard]] Index cells() const { return product(n); }
};

/// Calls visit(index) for the indices from first to last, both included.
template <typename Visit>
void for_window(const Int3& first, const Int3& last, const Visit& visit) {
  for (int k = first[2]; k <= last[2]; ++k) {
    for (int j = first[1]; j <= last[1]; ++j) {
      for (int i = first[0]; i <= last[0]; ++i) {
        visit(Int3{i, j, k});
      }
    }
  }
}

/// Calls visit(memory position) for the faces or cells of one layer normal to `axis`, ghosts included.
template <typename Visit>
void for_layer(const Block& b, int axis, int layer, const Visit& visit) {
  Int3 first{-b.ghost[0], -b.ghost[1], -b.ghost[2]};
  Int3 last{b.n[0] + b.ghost[0], b.n[1] + b.ghost[1], b.n[2] + b.ghost[2]};
  first[axis] = last[axis] = layer;
  for_window(first, last, [&](const Int3& q) { visit(b.at(q[0], q[1], q[2])); });
}

/// @param ghost_depth  layers on axes that are cut or periodic; one layer elsewhere
Block make_block(const par::Decomposition& decomposition, int rank,
                 const std::array<bool, 3>& periodic, int ghost_depth);

}  // namespace porefines::grid
