// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/types.hpp"

namespace porefines::geom {

/// What lies outside the sample box along an axis.
enum class Beyond {
  periodic,  ///< the sample again
  mirror,    ///< the sample reflected at the face, so that smoothing sees no jump there
  pore,      ///< open fluid: a reservoir before or after the sample
};
using Surroundings = std::array<Beyond, 3>;

/// Position of a voxel in the flat array, x fastest.
[[nodiscard]] inline Index voxel_index(const Int3& n, int i, int j, int k) {
  return i + Index{n[0]} * (j + Index{n[1]} * k);
}

/// Somebody else's binary volume: 1 = pore, 0 = grain, x fastest, y upwards.
/// A 2D image has n[2] = 1.
struct VoxelView {
  Int3 n{0, 0, 0};
  const std::uint8_t* pore = nullptr;
  const std::uint8_t* share = nullptr;  ///< see Voxels; null: all are full

  [[nodiscard]] bool at(int i, int j, int k) const { return pore[voxel_index(n, i, j, k)] != 0; }
};

/// Pore share of a voxel that is pore throughout; from half of it on a voxel counts as pore.
inline constexpr std::uint8_t full_share = 128;

/// A binary volume of one byte per voxel.
struct Voxels {
  Int3 n{0, 0, 0};
  std::vector<std::uint8_t> pore = {};
  /// Of a grey image: how much of each voxel is pore, 0..full_share. Empty: all of it, or nothing.
  std::vector<std::uint8_t> share = {};

  [[nodiscard]] std::uint8_t& at(int i, int j, int k) { return pore[voxel_index(n, i, j, k)]; }
  [[nodiscard]] bool at(int i, int j, int k) const { return pore[voxel_index(n, i, j, k)] != 0; }
  [[nodiscard]] VoxelView view() const {
    return {n, pore.data(), share.empty() ? nullptr : share.data()};
  }
};

[[nodiscard]] inline Voxels make_voxels(const Int3& n, std::uint8_t value) {
  return {n, std::vector<std::uint8_t>(static_cast<std::size_t>(product(n)), value), {}};
}

/// Index inside the sample that stands for index i along an axis; -1 where there is open pore.
[[nodiscard]] inline int fold(int i, int n, Beyond beyond) {
  if (i >= 0 && i < n) {
    return i;
  }
  switch (beyond) {
    case Beyond::periodic:
      return ((i % n) + n) % n;
    case Beyond::mirror: {
      const int m = ((i % (2 * n)) + 2 * n) % (2 * n);
      return m < n ? m : 2 * n - 1 - m;
    }
    case Beyond::pore:
      break;
  }
  return -1;
}

/// Whether a voxel is pore, also outside the sample. A 2D image is constant along z.
[[nodiscard]] inline bool is_pore(const VoxelView& voxels, const Surroundings& beyond, int i, int j,
                                  int k) {
  const int a = fold(i, voxels.n[0], beyond[0]);
  const int b = fold(j, voxels.n[1], beyond[1]);
  const int c = voxels.n[2] == 1 ? 0 : fold(k, voxels.n[2], beyond[2]);
  return a < 0 || b < 0 || c < 0 || voxels.at(a, b, c);
}

}  // namespace porefines::geom
