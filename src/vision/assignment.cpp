// SPDX-License-Identifier: MPL-2.0
#include "vision/assignment.hpp"

#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace porefines::vision {
namespace {

constexpr Real infinite = std::numeric_limits<Real>::max();

/// Columns are 0..columns-1 and, for row i that stays alone, columns + i.
class Matching {
 public:
  Matching(int rows, int columns, std::span<const Candidate> candidates,
           std::span<const Real> alone)
      : columns_(columns),
        candidates_(candidates),
        alone_(alone),
        start_(static_cast<std::size_t>(rows) + 1, 0),
        row_of_(static_cast<std::size_t>(columns + rows), -1),
        price_(row_of_.size(), 0),
        distance_(row_of_.size(), infinite),
        from_(row_of_.size(), -1),
        is_final_(row_of_.size(), 0),
        column_of_(static_cast<std::size_t>(rows), -1),
        cost_of_(static_cast<std::size_t>(rows), 0) {
    for (const Candidate& candidate : candidates) {
      ++start_[static_cast<std::size_t>(candidate.row) + 1];
    }
    for (std::size_t row = 1; row < start_.size(); ++row) {
      start_[row] += start_[row - 1];
    }
  }

  /// Gives `row` a column; others may have to change theirs.
  void place(int row) {
    relax(row, 0);
    while (true) {
      const auto [length, column] = nearest_.top();
      nearest_.pop();
      if (is_final_[at(column)] != 0) {
        continue;  // a shorter way was found meanwhile
      }
      is_final_[at(column)] = 1;
      final_.push_back(column);
      if (row_of_[at(column)] < 0) {
        finish(column, length);
        return;
      }
      const int next = row_of_[at(column)];
      relax(next, length - (cost_of_[at(next)] - price_[at(column)]));
    }
  }

  [[nodiscard]] std::vector<int> columns() const {
    std::vector<int> out = column_of_;
    for (int& column : out) {
      column = column < columns_ ? column : -1;
    }
    return out;
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  /// Ways to the columns of `row`, whose own way has this length.
  void relax(int row, Real length) {
    for (int k = start_[at(row)]; k < start_[at(row) + 1]; ++k) {
      reach(candidates_[at(k)].column, row, length + candidates_[at(k)].cost);
    }
    reach(columns_ + row, row, length + alone_[at(row)]);
  }

  void reach(int column, int row, Real length) {
    const Real reduced = length - price_[at(column)];
    if (is_final_[at(column)] == 0 && reduced < distance_[at(column)]) {
      if (distance_[at(column)] == infinite) {
        seen_.push_back(column);
      }
      distance_[at(column)] = reduced;
      from_[at(column)] = row;
      nearest_.push({reduced, column});
    }
  }

  [[nodiscard]] Real cost(int row, int column) const {
    if (column >= columns_) {
      return alone_[at(row)];
    }
    Real least = infinite;
    for (int k = start_[at(row)]; k < start_[at(row) + 1]; ++k) {
      if (candidates_[at(k)].column == column) {
        least = std::min(least, candidates_[at(k)].cost);
      }
    }
    return least;
  }

  /// New prices, then everybody on the way moves up by one.
  void finish(int end, Real length) {
    for (const int column : final_) {
      if (column != end) {
        price_[at(column)] += distance_[at(column)] - length;
      }
    }
    for (int column = end; column >= 0;) {
      const int row = from_[at(column)];
      const int freed = column_of_[at(row)];
      row_of_[at(column)] = row;
      column_of_[at(row)] = column;
      cost_of_[at(row)] = cost(row, column);
      column = freed;
    }
    for (const int column : seen_) {
      distance_[at(column)] = infinite;
      is_final_[at(column)] = 0;
    }
    seen_.clear();
    final_.clear();
    nearest_ = {};
  }

  using Way = std::pair<Real, int>;  ///< length, column: ties go to the lower column
  int columns_;
  std::span<const Candidate> candidates_;
  std::span<const Real> alone_;
  std::vector<int> start_;
  std::vector<int> row_of_;
  std::vector<Real> price_;
  std::vector<Real> distance_;
  std::vector<int> from_;
  std::vector<char> is_final_;
  std::vector<int> column_of_;
  std::vector<Real> cost_of_;
  std::vector<int> seen_;
  std::vector<int> final_;
  std::priority_queue<Way, std::vector<Way>, std::greater<>> nearest_;
};

}  // namespace

std::vector<int> assign(int rows, int columns, std::span<const Candidate> candidates,
                        std::span<const Real> alone) {
  Matching matching(rows, columns, candidates, alone);
  for (int row = 0; row < rows; ++row) {
    matching.place(row);
  }
  return matching.columns();
}

}  // namespace porefines::vision
