// SPDX-License-Identifier: MPL-2.0
#include "flow/face_network.hpp"

#include <algorithm>

namespace porefines::flow {

namespace {

constexpr int cells = 8;
using Matrix = std::array<std::array<Real, cells>, cells>;

void connect(Matrix& a, int c, int d, Real k) {
  a[c][c] += k;
  a[d][d] += k;
  a[c][d] -= k;
  a[d][c] -= k;
}

/// Conductance from each cell to its coarse cell's centre. A part of a layer (cells joined within
/// the layer) with no way to the outer layer is held where it leads out sideways.
std::array<Real, cells> terminals(const FaceNetwork& n) {
  std::array<int, cells> part{0, 1, 2, 3, 4, 5, 6, 7};
  const auto join = [&](int c, int d) {
    const int from = std::max(part[c], part[d]);
    const int to = std::min(part[c], part[d]);
    std::replace(part.begin(), part.end(), from, to);
  };
  for (int c = 0; c < cells; ++c) {
    if (n.across[0][c] > 0) {
      join(c, c + 1);
    }
    if (n.across[1][c] > 0) {
      join(c, c + 2);
    }
  }
  std::array<Real, cells> way_out{};
  Real strongest = *std::max_element(n.middle.begin(), n.middle.end());
  for (int c = 0; c < cells; ++c) {
    way_out[part[c]] += n.outer[c];
    strongest = std::max(strongest, n.outer[c]);
  }
  std::array<Real, cells> k = n.outer;
  for (int c = 0; c < cells; ++c) {
    if (way_out[part[c]] <= 0 && n.sideways[c]) {
      k[c] = FaceNetwork::held * strongest;
    }
  }
  return k;
}

/// Solves a p = b for a symmetric positive semi-definite matrix; unconnected cells get p = 0.
void eliminate(Matrix& a, std::array<Real, cells>& b) {
  for (int c = 0; c < cells; ++c) {
    if (a[c][c] <= 1e-12) {
      a[c] = {};
      b[c] = 0;
      continue;
    }
    for (int r = c + 1; r < cells; ++r) {
      const Real factor = a[r][c] / a[c][c];
      for (int j = c; factor != 0 && j < cells; ++j) {
        a[r][j] -= factor * a[c][j];
      }
      b[r] -= factor * b[c];
    }
  }
  for (int c = cells - 1; c >= 0; --c) {
    for (int j = c + 1; j < cells; ++j) {
      b[c] -= a[c][j] * b[j];
    }
    b[c] = a[c][c] > 0 ? b[c] / a[c][c] : 0;
  }
}

}  // namespace

Real effective_conductance(const FaceNetwork& n) {
  const std::array<Real, cells> held = terminals(n);
  Matrix a{};
  std::array<Real, cells> p{};
  for (int c = 0; c < cells; ++c) {
    if (c < 4 && n.middle[c] > 0) {
      connect(a, c, c + 4, n.middle[c]);
    }
    if (n.across[0][c] > 0) {
      connect(a, c, c + 1, n.across[0][c]);
    }
    if (n.across[1][c] > 0) {
      connect(a, c, c + 2, n.across[1][c]);
    }
    a[c][c] += held[c];
    p[c] = c < 4 ? held[c] : 0;
  }
  eliminate(a, p);
  Real through = 0;
  for (int c = 4; c < cells; ++c) {  // what arrives: no cancellation where terminals are strong
    through += held[c] * p[c];
  }
  return through;
}

}  // namespace porefines::flow
