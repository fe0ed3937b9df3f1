// SPDX-License-Identifier: MPL-2.0
#include "vision/gaussian.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "vision/levenberg_marquardt.hpp"

namespace porefines::vision {
namespace {

constexpr std::size_t unknowns = 5;  // x0, y0, a, s, b
using Vector = SmallVector<unknowns>;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// exp(-(start + k - middle)^2 / 2 width^2) for k = 0 .. count - 1, zeros after them. From the pixel next to
/// the middle outwards each is the one before times a ratio that shrinks by exp(-1/width^2).
void bell(int start, int count, Real middle, Real width, std::vector<Real>& out) {
  out.assign(at((count + 7) / 8 * 8), 0);
  const Real inverse = 1 / (width * width);
  const int nearest = std::clamp(static_cast<int>(std::lround(middle)) - start, 0, count - 1);
  const Real d = start + nearest - middle;
  const Real peak = std::exp(-0.5 * inverse * d * d);
  const Real shrink = std::exp(-inverse);
  out[at(nearest)] = peak;
  Real value = peak;
  Real ratio = std::exp(-inverse * (0.5 + d));
  for (int k = nearest + 1; k < count; ++k) {
    out[at(k)] = value *= ratio;
    ratio *= shrink;
  }
  value = peak;
  ratio = std::exp(-inverse * (0.5 - d));
  for (int k = nearest - 1; k >= 0; --k) {
    out[at(k)] = value *= ratio;
    ratio *= shrink;
  }
}

constexpr int lanes = 8;
using Lanes [[gnu::vector_size(lanes * sizeof(Real))]] = Real;  // of GCC and Clang

Lanes load(const std::vector<Real>& from, std::size_t start) {
  Lanes out;
  std::memcpy(&out, from.data() + start, sizeof out);
  return out;
}

/// Of eight columns, with f = exp(-dy^2 / 2 s^2) of a line: sums over the lines of (inside) f^2 dy^p,
/// (inside) f dy^p and light f dy^p.
struct ColumnSums {
  std::array<Lanes, 5> ff{};
  std::array<Lanes, 3> f{};
  std::array<Lanes, 3> light{};

  void add_line(const Lanes& inside, const Lanes& l, Real shape, Real d) {
    Lanes part = inside * shape;
    Lanes share = part * shape;
    Lanes shown = l * shape;
    for (std::size_t p = 0; p < 3; ++p) {
      f[p] += part, light[p] += shown, ff[p] += share;
      part *= d, shown *= d, share *= d;
    }
    ff[3] += share;
    ff[4] += share * d;
  }
};

/// Sums over the disc with powers dx^q dy^p and E = exp(-(dx^2 + dy^2) / 2 s^2): those that q + p <= 4, or 2, ask for.
struct DiscSums {
  Lanes a00{}, a10{}, a01{}, a20{}, a11{}, a02{}, a30{}, a21{}, a12{}, a03{}, a40{}, a22{},
      a04{};                        ///< E^2
  Lanes b00{}, b10{}, b01{}, b2{};  ///< E; b2 with dx^2 + dy^2
  Lanes l00{}, l10{}, l01{}, l2{};  ///< light E

  void add_columns(const ColumnSums& c, const Lanes& e, const Lanes& d) {
    const Lanes ed = e * d;
    const Lanes edd = ed * d;
    const Lanes ee = e * e;
    const Lanes eed = e * ed;
    const Lanes eedd = ed * ed;
    a00 += ee * c.ff[0], a10 += eed * c.ff[0], a01 += ee * c.ff[1];
    a20 += eedd * c.ff[0], a11 += eed * c.ff[1], a02 += ee * c.ff[2];
    a30 += ed * edd * c.ff[0], a21 += eedd * c.ff[1], a12 += eed * c.ff[2], a03 += ee * c.ff[3];
    a40 += edd * edd * c.ff[0], a22 += eedd * c.ff[2], a04 += ee * c.ff[4];
    b00 += e * c.f[0], b10 += ed * c.f[0], b01 += e * c.f[1], b2 += edd * c.f[0] + e * c.f[2];
    l00 += e * c.light[0], l10 += ed * c.light[0], l01 += e * c.light[1];
    l2 += edd * c.light[0] + e * c.light[2];
  }
};

Real total(const Lanes& v) {
  return ((v[0] + v[1]) + (v[2] + v[3])) + ((v[4] + v[5]) + (v[6] + v[7]));
}

/// Those of one Gaussian. Lines go into columns first, eight at a time, so that nothing is added across
/// before the end.
class Equations : public NormalEquations<unknowns> {
 public:
  void set(const Patch& p, const Patch::Sums& sums_of_patch, const Gaussian& g) {
    bell(p.x, p.columns, g.x, g.width, across_);
    bell(p.y, p.lines(), g.y, g.width, down_);
    const int stride = p.stride();
    DiscSums sums;
    for (int i = 0; i < stride; i += lanes) {
      ColumnSums columns;
      for (int j = 0; j < p.lines(); ++j) {
        const std::size_t start = at(j) * at(stride) + at(i);
        columns.add_line(load(p.inside, start), load(p.light, start), down_[at(j)], p.y + j - g.y);
      }
      const Real d = p.x + i - g.x;
      sums.add_columns(columns, load(across_, at(i)),
                       Lanes{d, d + 1, d + 2, d + 3, d + 4, d + 5, d + 6, d + 7});
    }
    fill(sums, sums_of_patch, g);
    scale(g);
  }

 private:
  /// Columns of J but for factors: dx E, dy E, E, (dx^2 + dy^2) E, 1.
  void fill(const DiscSums& s, const Patch::Sums& patch, const Gaussian& g) {
    const Real twos = total(s.a20 + s.a02);
    a[0][0] = total(s.a20);
    a[1][0] = total(s.a11);
    a[1][1] = total(s.a02);
    a[2][0] = total(s.a10);
    a[2][1] = total(s.a01);
    a[2][2] = total(s.a00);
    a[3][0] = total(s.a30 + s.a12);
    a[3][1] = total(s.a21 + s.a03);
    a[3][2] = twos;
    a[3][3] = total(s.a40 + 2 * s.a22 + s.a04);
    a[4][0] = total(s.b10);
    a[4][1] = total(s.b01);
    a[4][2] = total(s.b00);
    a[4][3] = total(s.b2);
    a[4][4] = patch.pixels;
    const std::array<Real, 4> light{total(s.l10), total(s.l01), total(s.l00), total(s.l2)};
    for (std::size_t k = 0; k < 4; ++k) {  // of the rest, light less the model
      b[k] = light[k] - g.height * (k == 3 ? twos : a[2][k]) - g.base * a[4][k];
    }
    b[4] = patch.light - g.height * a[4][2] - g.base * patch.pixels;
    squares = patch.squares + g.height * g.height * a[2][2] + g.base * g.base * patch.pixels -
              2 * g.height * light[2] - 2 * g.base * patch.light + 2 * g.height * g.base * a[4][2];
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

Patch::Sums Patch::sums() const {
  Sums out;
  for (std::size_t k = 0; k < light.size(); ++k) {
    out.pixels += inside[k];
    out.light += light[k];
    out.squares += light[k] * light[k];
  }
  return out;
}

void take_away(const Gaussian& g, Patch& p) {
  thread_local std::vector<Real> across;
  thread_local std::vector<Real> down;
  bell(p.x, p.columns, g.x, g.width, across);
  bell(p.y, p.lines(), g.y, g.width, down);
  for (int j = 0; j < p.lines(); ++j) {
    const Real height = g.height * down[at(j)];
    Real* const light = p.light.data() + at(j) * at(p.stride());
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
  const Patch::Sums sums = patch.sums();
  descend(
      g, here, there, most_steps, [&](const Gaussian& at, Equations& e) { e.set(patch, sums, at); },
      [&](const Gaussian& at, const Vector& change) { return moved(at, change, usual_width); },
      [](const Vector& change, Real, Real) { return std::hypot(change[0], change[1]) < at_rest; });
  return g;
}

}  // namespace porefines::vision
