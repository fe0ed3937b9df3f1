// SPDX-License-Identifier: MPL-2.0
#include "vision/gaussian.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "vision/levenberg_marquardt.hpp"

namespace porefines::vision {
namespace {

constexpr std::size_t unknowns = 5;  // x0, y0, a, s, b
using Vector = SmallVector<unknowns>;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// exp(-(start + k - middle)^2 / 2 width^2) for k = 0 .. count - 1
void bell(int start, int count, Real middle, Real width, std::vector<Real>& out) {
  out.resize(at(count));
  const Real factor = -0.5 / (width * width);
  for (int k = 0; k < count; ++k) {
    const Real d = start + k - middle;
    out[at(k)] = std::exp(factor * d * d);
  }
}

/// Sums over one line of e = exp(-dx^2 / 2 s^2) and the rest r = light - model, with powers of dx.
struct LineSums {
  std::array<Real, 5> ee{};  ///< e^2 dx^k
  std::array<Real, 3> e{};   ///< e dx^k
  std::array<Real, 3> re{};  ///< r e dx^k
  Real r = 0;
  Real rr = 0;
};

/// Those of one Gaussian, line by line.
class Equations : public NormalEquations<unknowns> {
 public:
  void set(const Patch& p, const Gaussian& g) {
    bell(p.x, p.columns, g.x, g.width, across_);
    bell(p.y, p.lines(), g.y, g.width, down_);
    a = {};
    b = {};
    squares = 0;
    for (int j = 0; j < p.lines(); ++j) {
      add_line(sums_of(p, g, j), p.y + j - g.y, down_[at(j)], p.right[at(j)] - p.left[at(j)]);
    }
    scale(g);
  }

 private:
  [[nodiscard]] LineSums sums_of(const Patch& p, const Gaussian& g, int j) const {
    LineSums s;
    const Real* const light = p.light.data() + at(j) * at(p.columns);
    const Real height = g.height * down_[at(j)];
    for (int i = p.left[at(j)]; i < p.right[at(j)]; ++i) {
      const Real e = across_[at(i)];
      const Real d = p.x + i - g.x;
      const Real r = light[i] - height * e - g.base;
      const Real ed = e * d;
      const Real edd = ed * d;
      s.e[0] += e;
      s.e[1] += ed;
      s.e[2] += edd;
      s.ee[0] += e * e;
      s.ee[1] += e * ed;
      s.ee[2] += ed * ed;
      s.ee[3] += ed * edd;
      s.ee[4] += edd * edd;
      s.r += r;
      s.rr += r * r;
      s.re[0] += r * e;
      s.re[1] += r * ed;
      s.re[2] += r * edd;
    }
    return s;
  }

  /// Columns of J but for factors: dx E, dy E, E, (dx^2 + dy^2) E, 1 with E = e f.
  void add_line(const LineSums& s, Real d, Real f, int count) {
    const Real ff = f * f;
    const Real dd = d * d;
    a[0][0] += ff * s.ee[2];
    a[1][0] += ff * d * s.ee[1];
    a[1][1] += ff * dd * s.ee[0];
    a[2][0] += ff * s.ee[1];
    a[2][1] += ff * d * s.ee[0];
    a[2][2] += ff * s.ee[0];
    a[3][0] += ff * (s.ee[3] + dd * s.ee[1]);
    a[3][1] += ff * d * (s.ee[2] + dd * s.ee[0]);
    a[3][2] += ff * (s.ee[2] + dd * s.ee[0]);
    a[3][3] += ff * (s.ee[4] + 2 * dd * s.ee[2] + dd * dd * s.ee[0]);
    a[4][0] += f * s.e[1];
    a[4][1] += f * d * s.e[0];
    a[4][2] += f * s.e[0];
    a[4][3] += f * (s.e[2] + dd * s.e[0]);
    a[4][4] += count;
    b[0] += f * s.re[1];
    b[1] += f * d * s.re[0];
    b[2] += f * s.re[0];
    b[3] += f * (s.re[2] + dd * s.re[0]);
    b[4] += s.r;
    squares += s.rr;
  }

  void scale(const Gaussian& g) {
    const Real slope = g.height / (g.width * g.width);
    const Vector factor{slope, slope, 1, slope / g.width, 1};
    for (std::size_t r = 0; r < unknowns; ++r) {
      b[r] *= factor[r];
      for (std::size_t c = 0; c <= r; ++c) {
        a[r][c] *= factor[r] * factor[c];
        a[c][r] = a[r][c];
      }
    }
  }

  std::vector<Real> across_;
  std::vector<Real> down_;
};

Gaussian moved(const Gaussian& g, const Vector& change, Real usual_width) {
  Gaussian next = g;
  next.x += change[0];
  next.y += change[1];
  next.height += change[2];
  next.width = std::clamp(g.width + change[3], 0.5 * usual_width, 2 * usual_width);
  next.base += change[4];
  return next;
}

}  // namespace

int Patch::pixels() const {
  int count = 0;
  for (std::size_t j = 0; j < left.size(); ++j) {
    count += right[j] - left[j];
  }
  return count;
}

void take_away(const Gaussian& g, Patch& p) {
  thread_local std::vector<Real> across;
  thread_local std::vector<Real> down;
  bell(p.x, p.columns, g.x, g.width, across);
  bell(p.y, p.lines(), g.y, g.width, down);
  for (int j = 0; j < p.lines(); ++j) {
    const Real height = g.height * down[at(j)];
    Real* const light = p.light.data() + at(j) * at(p.columns);
    for (int i = p.left[at(j)]; i < p.right[at(j)]; ++i) {
      light[i] -= height * across[at(i)];
    }
  }
}

Gaussian fit_gaussian(const Patch& patch, Gaussian g, Real usual_width) {
  constexpr int most_steps = 8;
  constexpr Real at_rest = 2e-3;  // [pixels]
  thread_local Equations here;
  thread_local Equations there;
  descend(
      g, here, there, most_steps, [&](const Gaussian& at, Equations& e) { e.set(patch, at); },
      [&](const Gaussian& at, const Vector& change) { return moved(at, change, usual_width); },
      [](const Vector& change, Real, Real) { return std::hypot(change[0], change[1]) < at_rest; });
  return g;
}

}  // namespace porefines::vision
