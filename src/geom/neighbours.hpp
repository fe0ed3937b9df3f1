// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>

#include "core/types.hpp"

namespace porefines::geom {

/// Visits the neighbours of a voxel inside the volume, through periodic faces as well.
class Neighbours {
 public:
  /// @param diagonal  26 neighbours (8 in 2D) instead of 6 (4)
  Neighbours(const Int3& n, const std::array<bool, 3>& periodic, bool diagonal)
      : n_(n), periodic_(periodic) {
    for (int a = 0; a < 27; ++a) {
      const Int3 d{a % 3 - 1, a / 3 % 3 - 1, a / 9 - 1};
      const int steps = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
      if (steps > 0 && (diagonal || steps == 1) && (n[2] > 1 || d[2] == 0)) {
        offset_[count_] = d[0] + Index{n[0]} * (d[1] + Index{n[1]} * d[2]);
        step_[count_++] = d;
      }
    }
  }

  template <class Visit>
  void visit(Index v, const Visit& visitor) const {
    const Int3 x{static_cast<int>(v % n_[0]), static_cast<int>(v / n_[0] % n_[1]),
                 static_cast<int>(v / (Index{n_[0]} * n_[1]))};
    const bool interior = x[0] > 0 && x[0] < n_[0] - 1 && x[1] > 0 && x[1] < n_[1] - 1 &&
                          (n_[2] == 1 || (x[2] > 0 && x[2] < n_[2] - 1));
    for (std::size_t s = 0; interior && s < count_; ++s) {
      visitor(v + offset_[s]);
    }
    for (std::size_t s = 0; !interior && s < count_; ++s) {
      Int3 y{};
      bool inside = true;
      for (std::size_t a = 0; a < 3; ++a) {
        y[a] = x[a] + step_[s][a];
        if (y[a] < 0 || y[a] >= n_[a]) {
          inside = inside && periodic_[a];
          y[a] = y[a] < 0 ? n_[a] - 1 : 0;
        }
      }
      if (inside) {
        visitor(y[0] + Index{n_[0]} * (y[1] + Index{n_[1]} * y[2]));
      }
    }
  }

 private:
  Int3 n_;
  std::array<bool, 3> periodic_;
  std::array<Int3, 26> step_{};
  std::array<Index, 26> offset_{};  ///< away from the faces
  std::size_t count_ = 0;
};

}  // namespace porefines::geom
