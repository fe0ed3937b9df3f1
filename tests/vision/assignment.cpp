// SPDX-License-Identifier: MPL-2.0
#include "vision/assignment.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace porefines::vision {
namespace {

struct Problem {
  int rows = 0;
  int columns = 0;
  std::vector<Candidate> candidates;
  std::vector<Real> alone;
};

Problem random_problem(std::uint64_t id, int rows, int columns, Real density) {
  Draws draws(3, Stream::place, id);
  Problem p{rows, columns, {}, {}};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      if (draws.uniform() < density) {
        p.candidates.push_back({row, column, draws.uniform(-0.3, 1)});
      }
    }
    p.alone.push_back(draws.uniform(0.2, 0.9));
  }
  return p;
}

Real cost_of(const Problem& p, const std::vector<int>& columns) {
  Real sum = 0;
  for (int row = 0; row < p.rows; ++row) {
    const int column = columns[static_cast<std::size_t>(row)];
    Real cost = column < 0 ? p.alone[static_cast<std::size_t>(row)] : 1e9;
    for (const Candidate& c : p.candidates) {
      cost = c.row == row && c.column == column ? c.cost : cost;
    }
    sum += cost;
  }
  return sum;
}

/// Tries everything.
Real least(const Problem& p, int row, std::vector<bool>& taken) {
  if (row == p.rows) {
    return 0;
  }
  Real best = p.alone[static_cast<std::size_t>(row)] + least(p, row + 1, taken);
  for (const Candidate& c : p.candidates) {
    const auto column = static_cast<std::size_t>(c.column);
    if (c.row == row && !taken[column]) {
      taken[column] = true;
      best = std::min(best, c.cost + least(p, row + 1, taken));
      taken[column] = false;
    }
  }
  return best;
}

TEST(Assignment, is_as_good_as_trying_everything) {
  for (std::uint64_t id = 0; id < 400; ++id) {
    const Problem p = random_problem(id, 2 + static_cast<int>(id % 5),
                                     2 + static_cast<int>(id / 5 % 5), id % 2 == 0 ? 0.9 : 0.4);
    const auto columns = assign(p.rows, p.columns, p.candidates, p.alone);
    std::vector<bool> taken(static_cast<std::size_t>(p.columns), false);
    EXPECT_NEAR(cost_of(p, columns), least(p, 0, taken), 1e-12) << id;
  }
}

TEST(Assignment, gives_no_column_twice) {
  const Problem p = random_problem(1, 300, 280, 0.05);
  const auto columns = assign(p.rows, p.columns, p.candidates, p.alone);
  std::multiset<int> used(columns.begin(), columns.end());
  for (int column = 0; column < p.columns; ++column) {
    EXPECT_LE(used.count(column), 1U);
  }
  EXPECT_LT(cost_of(p, columns), 1e6);
}

TEST(Assignment, needs_neither_rows_nor_candidates) {
  EXPECT_TRUE(assign(0, 3, {}, {}).empty());
  EXPECT_EQ(assign(2, 0, {}, std::vector<Real>{1, 1}), (std::vector<int>{-1, -1}));
}

}  // namespace
}  // namespace porefines::vision
