// SPDX-License-Identifier: MPL-2.0
#include "flow/axis.hpp"

#include <algorithm>

namespace porefines::flow {

namespace {

/// Cell widths continued beyond the ends: periodic, or mirrored at the boundary.
class Widths {
 public:
  Widths(const std::vector<Real>& widths, bool periodic) : w_(widths), periodic_(periodic) {}
  [[nodiscard]] int size() const { return static_cast<int>(w_.size()); }
  [[nodiscard]] Real cell(int i) const {
    const int n = size();
    if (periodic_) {
      return w_[((i % n) + n) % n];
    }
    return w_[std::clamp(i < 0 ? -1 - i : i >= n ? 2 * n - 1 - i : i, 0, n - 1)];
  }
  /// Distance between the centres of cells i-1 and i.
  [[nodiscard]] Real between(int i) const { return (cell(i - 1) + cell(i)) / 2; }

 private:
  const std::vector<Real>& w_;
  bool periodic_;
};

}  // namespace

AxisCoefficients make_axis(const grid::Block& block, int axis, const std::vector<Real>& widths,
                           const Boundaries& boundaries) {
  const bool periodic = boundaries.periodic(axis);
  const Widths w(widths, periodic);
  const int total = w.size();
  AxisCoefficients c;
  c.offset = block.ghost[axis];
  const auto length =
      static_cast<std::size_t>(block.n[axis] + 2 * c.offset + 1 + 2 * grid::line_width);
  for (auto* array : {&c.face_low, &c.face_high, &c.cell_low, &c.cell_high, &c.gradient,
                      &c.divergence, &c.owned_cell, &c.owned_face}) {
    array->assign(length, 0.0F);
  }
  for (int i = -c.offset; i <= block.n[axis] + c.offset; ++i) {
    const int here = i + block.start[axis];
    const std::size_t at = i + c.offset;
    c.owned_cell[at] = i >= 0 && i < block.n[axis] ? 1.0F : 0.0F;
    c.owned_face[at] = i >= 0 && i < block.n[axis] + (block.owns_end[axis] ? 1 : 0) ? 1.0F : 0.0F;
    if ((periodic && total == 1) || (!periodic && (here < 0 || here > total))) {
      continue;
    }
    const bool mirror_low = !periodic && here == 0;
    const bool mirror_high = !periodic && here == total;
    const Real d = w.between(here);
    const Real both = (1 / w.cell(here - 1) + 1 / w.cell(here)) / d;
    c.face_low[at] = static_cast<float>(mirror_low    ? 0
                                        : mirror_high ? both
                                                      : 1 / (w.cell(here - 1) * d));
    c.face_high[at] = static_cast<float>(mirror_high  ? 0
                                         : mirror_low ? both
                                                      : 1 / (w.cell(here) * d));
    c.gradient[at] = static_cast<float>((mirror_low || mirror_high ? 2 : 1) / d);
    if (periodic || here < total) {
      c.cell_low[at] = static_cast<float>(1 / (w.cell(here) * d));
      c.cell_high[at] = static_cast<float>(1 / (w.cell(here) * w.between(here + 1)));
      c.divergence[at] = static_cast<float>(1 / w.cell(here));
    }
  }
  return c;
}

AxisTransfer make_transfer(const grid::Block& fine, int axis, const std::vector<Real>& fine_widths,
                           const std::vector<Real>& coarse_widths, const Boundaries& boundaries) {
  const bool periodic = boundaries.periodic(axis);
  const Widths f(fine_widths, periodic);
  const Widths c(coarse_widths, periodic);
  AxisTransfer t;
  t.coarsened = f.size() > c.size();
  t.ratio = f.size() > 1 && !t.coarsened ? 1 : 2;
  const int first = fine.start[axis] / t.ratio;
  const int count = (fine.n[axis] + t.ratio - 1) / t.ratio;
  for (auto* array : {&t.cell_first, &t.cell_second, &t.face_before, &t.face_middle, &t.face_after,
                      &t.odd_low, &t.odd_high}) {
    array->assign(static_cast<std::size_t>(count) + 1, 0.0F);
  }
  if (t.ratio == 1) {
    t.cell_first.assign(static_cast<std::size_t>(count) + 1, 1.0F);
    t.face_middle.assign(static_cast<std::size_t>(count) + 1, 1.0F);
    return t;
  }
  const auto has_second = [&](int coarse) {
    const int n = c.size();
    const int wrapped = periodic ? ((coarse % n) + n) % n : coarse;
    return wrapped >= 0 && 2 * wrapped + 1 < f.size();
  };
  for (int I = 0; I <= count; ++I) {
    const int coarse = first + I;
    const int here = 2 * coarse;  // global fine index of child and face 2I
    const auto at = static_cast<std::size_t>(I);
    if (I < count) {
      t.cell_first[at] = static_cast<float>(f.cell(here) / c.cell(coarse));
      t.cell_second[at] =
          static_cast<float>(has_second(coarse) ? f.cell(here + 1) / c.cell(coarse) : 0);
      // A last cell with one child ends at an odd fine face, which is coarse face I+1 itself.
      t.odd_low[at] = has_second(coarse) ? 0.5F : 0.0F;
      t.odd_high[at] = has_second(coarse) ? 0.5F : 1.0F;
    }
    if (!t.coarsened) {
      t.face_middle[at] = 1.0F;
      continue;
    }
    const Real d = c.between(coarse);
    const bool mirror_low = !periodic && coarse == 0;
    const bool mirror_high = !periodic && coarse == c.size();
    // The last coarse face lies behind the last fine cell, be that an odd or an even one.
    const int middle = mirror_high ? f.size() : here;
    t.face_middle[at] = static_cast<float>(f.between(middle) / d);
    if (!mirror_low && has_second(coarse - 1)) {
      t.face_before[at] = static_cast<float>((mirror_high ? 1 : 0.5) * f.between(middle - 1) / d);
    }
    if (!mirror_high && has_second(coarse)) {
      t.face_after[at] = static_cast<float>((mirror_low ? 1 : 0.5) * f.between(here + 1) / d);
    }
  }
  return t;
}

}  // namespace porefines::flow
