// SPDX-License-Identifier: MPL-2.0
#include "analysis/near_points.hpp"

#include <cmath>
#include <numeric>

namespace porefines::analysis {

Vec3 PointBox::way(const Vec3& from, const Vec3& to) const {
  Vec3 d = to - from;
  for (int axis = 0; axis < 3; ++axis) {
    if (periodic[static_cast<std::size_t>(axis)]) {
      d[axis] -= size[axis] * std::round(d[axis] / size[axis]);
    }
  }
  return d;
}

NearPoints::NearPoints(std::span<const Vec3> points, Real distance, const PointBox& box)
    : points_(points), box_(box) {
  Vec3 high = points.empty() ? Vec3{} : points[0];
  low_ = high;
  for (const Vec3& x : points) {
    for (int axis = 0; axis < 3; ++axis) {
      low_[axis] = std::min(low_[axis], x[axis]);
      high[axis] = std::max(high[axis], x[axis]);
    }
  }
  choose_cells(high, distance);
  first_.assign(static_cast<std::size_t>(product(n_)) + 1, 0);
  std::vector<Index> cell_of(points.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    Index at = 0;
    for (int axis = 2; axis >= 0; --axis) {
      at = at * n_[axis] + std::clamp(cell_along(points[p][axis], axis), 0, n_[axis] - 1);
    }
    cell_of[p] = at;
    ++first_[static_cast<std::size_t>(at) + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  list_.resize(points.size());
  std::vector<Index> next(first_.begin(), first_.end() - 1);
  for (std::size_t p = 0; p < points.size(); ++p) {
    list_[static_cast<std::size_t>(next[static_cast<std::size_t>(cell_of[p])]++)] =
        static_cast<std::int32_t>(p);
  }
}

void NearPoints::choose_cells(Vec3 high, Real distance) {
  constexpr Real many = 1e6;
  Vec3 length;
  for (int axis = 0; axis < 3; ++axis) {
    if (box_.periodic[static_cast<std::size_t>(axis)]) {
      low_[axis] = 0;
      high[axis] = box_.size[axis];
    }
    length[axis] = high[axis] - low_[axis];
    const Real fit = distance > 0 ? std::floor(length[axis] / distance) : many;
    n_[axis] = length[axis] > 0 ? static_cast<int>(std::clamp<Real>(fit, 1, many)) : 1;
  }
  while (product(n_) > 2 * static_cast<Index>(points_.size()) + 1) {
    int& longest = *std::max_element(n_.begin(), n_.end());
    longest = (longest + 1) / 2;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const Real edge = std::max(length[axis] / n_[axis], distance);
    cell_[axis] = edge > 0 ? edge : 1;
  }
}

int NearPoints::cell_along(Real x, int axis) const {
  const Real size = box_.size[axis];
  const Real inside =
      box_.periodic[static_cast<std::size_t>(axis)] ? x - size * std::floor(x / size) : x;
  const Real cell = std::floor((inside - low_[axis]) / cell_[axis]);
  return static_cast<int>(std::clamp<Real>(cell, -2, n_[axis] + 1));
}

int NearPoints::around(Real x, int axis, std::array<int, 3>& cells) const {
  const int n = n_[axis];
  const bool periodic = box_.periodic[static_cast<std::size_t>(axis)];
  const int here = cell_along(x, axis);
  int count = 0;
  for (int step = -1; step <= 1; ++step) {
    int cell = here + step;
    if (periodic) {
      cell = (cell + n) % n;
    }
    const bool listed =
        std::find(cells.begin(), cells.begin() + count, cell) != cells.begin() + count;
    if (cell >= 0 && cell < n && !listed) {
      cells[static_cast<std::size_t>(count++)] = cell;
    }
  }
  return count;
}

}  // namespace porefines::analysis
