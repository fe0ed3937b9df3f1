// SPDX-License-Identifier: MPL-2.0
#include "flow/advection.hpp"

#include <algorithm>

namespace porefines::flow {

namespace {

constexpr int width = grid::line_width;
constexpr int spare = 2;            ///< entries before index -ghost in the masks
constexpr float blend = 1.0F / 16;  ///< kappa of LUST

/// One line of a component's faces along one axis.
struct Side {
  const float* carrier;  ///< velocity along the axis, at the line
  const float* weight;
  const float* value;      ///< the component itself
  const float* carrier_z;  ///< the change's
  const float* value_z;
  std::ptrdiff_t across;  ///< from one cell beside the face to the other
  std::ptrdiff_t along;   ///< stride of the axis
  const float* bend;      ///< masks at lane 0
  float per_width;
};

template <bool normal>
inline float flux(const float* u, const float* w, std::ptrdiff_t low, std::ptrdiff_t across,
                  std::ptrdiff_t along) {
  return normal ? 0.5F * (w[low] * u[low] + w[low + along] * u[low + along])
                : 0.5F * (w[low] * u[low] + w[low - across] * u[low - across]);
}

/// Value at the side between `low` and the next along the axis.
template <bool upwind>
inline float side_value(const float* v, std::ptrdiff_t low, std::ptrdiff_t s, bool upwards,
                        float bend_low, float bend_high) {
  const float mean = 0.5F * (v[low] + v[low + s]);
  if constexpr (!upwind) {
    return mean;
  } else {
    const float at_low = bend_low * (v[low - s] - 2 * v[low] + v[low + s]);
    const float at_high = bend_high * (v[low] - 2 * v[low + s] + v[low + 2 * s]);
    return mean - blend * (upwards ? at_low : at_high);
  }
}

/// out += (F v at the high side - F v at the low side)/h for 16 faces.
template <bool normal, bool upwind, bool linearised, bool lanewise>
void add_side(const Side& q, float* __restrict out) {
  const std::ptrdiff_t s = q.along;
#pragma omp simd
  for (int l = 0; l < width; ++l) {
    const float* m = q.bend + (lanewise ? l : 0);
    const float mh = upwind ? m[1] : 0.0F;
    const float m0 = upwind ? m[0] : 0.0F;
    const float ml = upwind ? m[-1] : 0.0F;
    // Sides: normal: between face and next face; else in the plane of the cells' own faces.
    const std::ptrdiff_t high = normal ? l : l + s;
    const std::ptrdiff_t low = normal ? l - s : l;
    const float fh = flux<normal>(q.carrier, q.weight, high, q.across, s);
    const float fl = flux<normal>(q.carrier, q.weight, low, q.across, s);
    float sum = 0;
    if constexpr (linearised) {
      const float zh = flux<normal>(q.carrier_z, q.weight, high, q.across, s);
      const float zl = flux<normal>(q.carrier_z, q.weight, low, q.across, s);
      sum = fh * side_value<upwind>(q.value_z, l, s, fh > 0, m0, mh) -
            fl * side_value<upwind>(q.value_z, l - s, s, fl > 0, ml, m0) +
            zh * side_value<upwind>(q.value, l, s, fh > 0, m0, mh) -
            zl * side_value<upwind>(q.value, l - s, s, fl > 0, ml, m0);
    } else {
      sum = fh * side_value<upwind>(q.value, l, s, fh > 0, m0, mh) -
            fl * side_value<upwind>(q.value, l - s, s, fl > 0, ml, m0);
    }
    out[l] += q.per_width * sum;
  }
}

/// Masks of second differences along one axis: places 0 .. count-1 of the box, ends left out.
std::vector<float> bends(const grid::Block& b, int axis, bool periodic, int count) {
  std::vector<float> mask(static_cast<std::size_t>(b.n[axis] + 2 * b.ghost[axis] + 1) + 2 * spare +
                          2 * width);
  for (int i = -b.ghost[axis]; i <= b.n[axis] + b.ghost[axis]; ++i) {
    const int here = i + b.start[axis];
    const bool inner = here > 0 && here < count - 1;
    mask[i + b.ghost[axis] + spare] = periodic || inner ? 1.0F : 0.0F;
  }
  return mask;
}

}  // namespace

Advection::Advection(const Level& level, const Boundaries& boundaries, Scheme scheme)
    : level_(level), boundaries_(boundaries), scheme_(scheme) {
  const grid::Block& b = level.block;
  for (int a = 0; a < 3; ++a) {
    const bool periodic = boundaries.periodic(a);
    bends_face_[a] = bends(b, a, periodic, b.global[a] + 1);
    bends_cell_[a] = bends(b, a, periodic, b.global[a]);
    const bool uniform = periodic && b.global[a] == 1;  // the same on both sides: cancels
    per_width_[a] = uniform ? 0.0F : static_cast<float>(1 / level.widths[a].front());
    moves_[a] = std::any_of(level.inverse_diagonal[a].begin(), level.inverse_diagonal[a].end(),
                            [](float d) { return d != 0; });
  }
}

template <bool upwind, bool linearised>
void Advection::run(const Operator& op, const FaceVelocity& u, const FaceVelocity& z,
                    Packed<float>& out) const {
  const grid::Block& b = level_.block;
  const auto side = [&](int c, int t, const Int3& index) {
    const std::ptrdiff_t at = b.at(index[0], index[1], index[2]);
    const auto& mask = t == c ? bends_face_[t] : bends_cell_[t];
    return Side{u.data(t) + at, level_.weight[t].data() + at,
                u.data(c) + at, z.data(t) + at,
                z.data(c) + at, b.stride(c),
                b.stride(t),    mask.data() + index[t] + b.ghost[t] + spare,

                per_width_[t]};
  };
  op.for_each_line([&](int i, int j, int k, std::size_t to) {
    const Int3 index{i, j, k};
    const auto& axis = level_.axis;
    for (int c = 0; c < 3; ++c) {
      float* line = out.data() + to + c * width;
      std::fill_n(line, width, 0.0F);
      if (!moves_[c]) {
        continue;
      }
      alignas(64) std::array<float, width> sum{};
      for (int t = 0; t < 3; ++t) {
        if (!moves_[t]) {
          continue;
        }
        const Side q = side(c, t, index);
        if (t == c) {
          t == 0 ? add_side<true, upwind, linearised, true>(q, sum.data())
                 : add_side<true, upwind, linearised, false>(q, sum.data());
        } else {
          t == 0 ? add_side<false, upwind, linearised, true>(q, sum.data())
                 : add_side<false, upwind, linearised, false>(q, sum.data());
        }
      }
      const auto owned = [&](int a) -> const std::vector<float>& {
        return a == c ? axis[a].owned_face : axis[a].owned_cell;
      };
      const float row = owned(1)[j + axis[1].offset] * owned(2)[k + axis[2].offset];
      const float* owned_x = owned(0).data() + i + axis[0].offset;
      const float* inverse = level_.inverse_diagonal[c].data() + b.at(i, j, k);
#pragma omp simd
      for (int l = 0; l < width; ++l) {
        line[l] = inverse[l] != 0 ? sum[l] * row * owned_x[l] : 0.0F;
      }
    }
    std::fill_n(out.data() + to + 3 * width, width, 0.0F);
  });
  carry_openings(op, u, z, linearised, out);
}

namespace {

/// u du/dn outwards + u_t du/dt at a face of an opening, in pairs (carrier, carried).
class Opening {
 public:
  Opening(const Level& level, const std::array<float, 3>& per_width, int axis, bool high,
          bool slides)
      : level_(level), per_width_(per_width), axis_(axis), high_(high), slides_(slides) {}

  [[nodiscard]] float carry(const FaceVelocity& direction, const FaceVelocity& carrier,
                            const FaceVelocity& carried, std::ptrdiff_t at) const {
    const grid::Block& b = level_.block;
    const std::ptrdiff_t in = high_ ? -b.stride(axis_) : b.stride(axis_);
    const float* u = carried.data(axis_);
    const float sign = high_ ? 1.0F : -1.0F;
    float sum = 0;
    if (sign * direction.data(axis_)[at] > 0) {
      sum += carrier.data(axis_)[at] * sign * (u[at] - u[at + in]) * per_width_[axis_];
    }
    for (int t = 0; t < 3 && slides_; ++t) {
      if (t == axis_) {
        continue;
      }
      const std::ptrdiff_t s = b.stride(t);
      const std::ptrdiff_t cell = high_ ? at - b.stride(axis_) : at;
      const float across = 0.5F * (carrier.data(t)[cell] + carrier.data(t)[cell + s]);
      const auto& open = level_.inverse_diagonal[axis_];
      const float above = open[at + s] != 0 ? u[at + s] : u[at];
      const float below = open[at - s] != 0 ? u[at - s] : u[at];
      sum += across * 0.5F * (above - below) * per_width_[t];
    }
    return sum * level_.weight[axis_][at];
  }

 private:
  const Level& level_;
  const std::array<float, 3>& per_width_;
  int axis_;
  bool high_;
  bool slides_;  ///< may fluid move along the opening?
};

}  // namespace

void Advection::carry_openings(const Operator& op, const FaceVelocity& u, const FaceVelocity& z,
                               bool linearised, Packed<float>& out) const {
  const grid::Block& b = level_.block;
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool high : {false, true}) {
      const FaceKind kind = boundaries_.at(axis, high);
      const bool mine = high ? b.owns_end[axis] : b.start[axis] == 0;
      if (!gives_pressure(kind) || !mine) {
        continue;
      }
      const Opening opening(level_, per_width_, axis, high, kind == FaceKind::outflow);
      Int3 first{0, 0, 0};
      Int3 last{b.n[0] - 1, b.n[1] - 1, b.n[2] - 1};
      first[axis] = last[axis] = high ? b.n[axis] : 0;
      for (int k = first[2]; k <= last[2]; ++k) {
        for (int j = first[1]; j <= last[1]; ++j) {
          for (int i = first[0]; i <= last[0]; ++i) {
            const std::ptrdiff_t at = b.at(i, j, k);
            if (level_.inverse_diagonal[axis][at] != 0) {
              out[op.position(axis, {i, j, k})] =
                  linearised ? opening.carry(u, u, z, at) + opening.carry(u, z, u, at)
                             : opening.carry(u, u, u, at);
            }
          }
        }
      }
    }
  }
}

void Advection::apply(const Operator& op, const FaceVelocity& u, Packed<float>& out) const {
  scheme_ != Scheme::lust ? run<false, false>(op, u, u, out) : run<true, false>(op, u, u, out);
}

void Advection::change(const Operator& op, const FaceVelocity& u, const FaceVelocity& z,
                       Packed<float>& out) const {
  scheme_ != Scheme::lust ? run<false, true>(op, u, z, out) : run<true, true>(op, u, z, out);
}

}  // namespace porefines::flow
