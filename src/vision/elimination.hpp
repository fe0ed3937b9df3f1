// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <cstddef>

#include "core/types.hpp"

namespace porefines::vision {

template <std::size_t n>
using SmallVector = std::array<Real, n>;
template <std::size_t n>
using SmallMatrix = std::array<SmallVector<n>, n>;

/// a x = b by Gaussian elimination of a positive definite matrix; false when it is not one.
template <std::size_t n>
bool solve(SmallMatrix<n> a, SmallVector<n> b, SmallVector<n>& x) {
  for (std::size_t k = 0; k < n; ++k) {
    if (!(a[k][k] > 0)) {
      return false;
    }
    for (std::size_t r = k + 1; r < n; ++r) {
      const Real factor = a[r][k] / a[k][k];
      for (std::size_t c = k; c < n; ++c) {
        a[r][c] -= factor * a[k][c];
      }
      b[r] -= factor * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    Real sum = b[k];
    for (std::size_t c = k + 1; c < n; ++c) {
      sum -= a[k][c] * x[c];
    }
    x[k] = sum / a[k][k];
  }
  return true;
}

}  // namespace porefines::vision
