// SPDX-License-Identifier: MPL-2.0
#include "core/six.hpp"

#include <cmath>

namespace porefines {

Six times(const SixBySix& a, const Six& x) {
  Six y{};
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      y[i] += a[6 * i + j] * x[j];
    }
  }
  return y;
}

SixBySix cholesky(SixBySix a, Real ridge) {
  Real trace = 0;
  for (int i = 0; i < 6; ++i) {
    trace += a[7 * i];
  }
  ridge = trace > 0 ? ridge * trace : 1;
  SixBySix lower{};
  for (int i = 0; i < 6; ++i) {
    a[7 * i] += ridge;
    for (int j = 0; j <= i; ++j) {
      Real sum = a[6 * i + j];
      for (int k = 0; k < j; ++k) {
        sum -= lower[6 * i + k] * lower[6 * j + k];
      }
      lower[6 * i + j] = i == j ? std::sqrt(std::fmax(sum, ridge)) : sum / lower[7 * j];
    }
  }
  return lower;
}

Six solve_lower(const SixBySix& lower, Six b) {
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < i; ++j) {
      b[i] -= lower[6 * i + j] * b[j];
    }
    b[i] /= lower[7 * i];
  }
  return b;
}

Six solve_upper(const SixBySix& lower, Six b) {
  for (int i = 5; i >= 0; --i) {
    for (int j = i + 1; j < 6; ++j) {
      b[i] -= lower[6 * j + i] * b[j];
    }
    b[i] /= lower[7 * i];
  }
  return b;
}

Six solved(const SixBySix& lower, const Six& b) {
  return solve_upper(lower, solve_lower(lower, b));
}

SixBySix inverse_from(const SixBySix& lower) {
  SixBySix inverse{};
  for (int j = 0; j < 6; ++j) {
    Six unit{};
    unit[j] = 1;
    const Six column = solved(lower, unit);
    for (int i = 0; i < 6; ++i) {
      inverse[6 * i + j] = column[i];
    }
  }
  return inverse;
}

}  // namespace porefines
