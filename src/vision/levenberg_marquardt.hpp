// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <cstddef>
#include <utility>

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
    const Real inverse = 1 / a[k][k];
    for (std::size_t r = k + 1; r < n; ++r) {
      const Real factor = a[r][k] * inverse;
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

/// J^T J, J^T r and r^T r of light = model.
template <std::size_t n>
struct NormalEquations {
  SmallMatrix<n> a{};
  SmallVector<n> b{};
  Real squares = 0;
};

/// Levenberg-Marquardt in a few unknowns, from `model` on: (J^T J + damping diag) change = J^T r, with a tenth of
/// the damping after a step that does not raise the sum of squares, ten times as much after one that would.
/// @param here, there  memory for two sets of NormalEquations; on return `here` is that of the model
/// @param set          set(model, equations)
/// @param moved        moved(model, change), a model
/// @param rests        rests(change, squares before, squares after) ends it
template <class Model, class Equations, class Set, class Move, class Rests>
void descend(Model& model, Equations& here, Equations& there, int most_steps, const Set& set,
             const Move& moved, const Rests& rests) {
  Real damping = 1e-3;
  set(model, here);
  for (int step = 0; step < most_steps; ++step) {
    auto damped = here.a;
    for (std::size_t k = 0; k < damped.size(); ++k) {
      damped[k][k] *= 1 + damping;
    }
    decltype(here.b) change{};
    if (!solve(damped, here.b, change)) {
      return;
    }
    const Model next = moved(model, change);
    set(next, there);
    if (!(there.squares <= here.squares)) {
      damping *= 10;
      continue;
    }
    model = next;
    std::swap(here, there);
    damping *= 0.1;
    if (rests(change, there.squares, here.squares)) {
      return;
    }
  }
}

}  // namespace porefines::vision
