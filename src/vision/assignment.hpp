// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <span>
#include <vector>

#include "core/types.hpp"

namespace porefines::vision {

/// A row may take this column at this cost.
struct Candidate {
  int row = 0;
  int column = 0;
  Real cost = 0;
};

/// Chooses at most one column for every row such that
///
///     sum of the costs of what is chosen + sum of alone[row] over rows without a column
///
/// is least. Shortest augmenting paths with column prices over the candidates only, so the cost grows
/// with the number of candidates, not with rows times columns.
/// @param candidates  sorted by row; costs may be negative
/// @return            the column of every row, or -1
/// Source: Jonker & Volgenant, Computing 38 (1987) 325. Test: unit/vision_assignment (all
/// permutations tried).
[[nodiscard]] std::vector<int> assign(int rows, int columns, std::span<const Candidate> candidates,
                                      std::span<const Real> alone);

}  // namespace porefines::vision
