// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace porefines::analysis {

/// The box that points live in; they may lie outside along axes that are not periodic.
struct PointBox {
  Vec3 size;  ///< [m] from the origin
  std::array<bool, 3> periodic{};

  /// The shortest way from one point to another.
  [[nodiscard]] Vec3 way(const Vec3& from, const Vec3& to) const;
};

/// Points sorted into cells no smaller than a distance: who is near is found in O(1).
/// Cells number at most twice the points. Test: unit/near_points (against all pairs).
class NearPoints {
 public:
  /// @param distance  [m] up to which visit() finds everybody
  NearPoints(std::span<const Vec3> points, Real distance, const PointBox& box);

  /// Calls visitor(j, way from x to point j) once for every point within the distance of x, and for
  /// some beyond it; in an order that depends on the points alone.
  template <class Visitor>
  void visit(const Vec3& x, const Visitor& visitor) const;

 private:
  void choose_cells(Vec3 high, Real distance);
  [[nodiscard]] int cell_along(Real x, int axis) const;
  /// Cells to look at along an axis, each once.
  [[nodiscard]] int around(Real x, int axis, std::array<int, 3>& cells) const;

  std::span<const Vec3> points_;
  PointBox box_;
  Vec3 low_;
  Vec3 cell_;
  Int3 n_{1, 1, 1};
  std::vector<Index> first_;  ///< per cell: where its list starts; one more at the end
  std::vector<std::int32_t> list_;
};

template <class Visitor>
void NearPoints::visit(const Vec3& x, const Visitor& visitor) const {
  std::array<std::array<int, 3>, 3> cells{};
  std::array<int, 3> count{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    count[a] = around(x[axis], axis, cells[a]);
  }
  for (int k = 0; k < count[2]; ++k) {
    for (int j = 0; j < count[1]; ++j) {
      for (int i = 0; i < count[0]; ++i) {
        const auto at = static_cast<std::size_t>(
            cells[0][i] + n_[0] * (cells[1][j] + Index{n_[1]} * cells[2][k]));
        for (Index entry = first_[at]; entry < first_[at + 1]; ++entry) {
          const std::int32_t point = list_[static_cast<std::size_t>(entry)];
          visitor(point, box_.way(x, points_[static_cast<std::size_t>(point)]));
        }
      }
    }
  }
}

}  // namespace porefines::analysis
