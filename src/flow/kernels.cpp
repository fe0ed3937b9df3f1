// SPDX-License-Identifier: MPL-2.0
#include "flow/kernels.hpp"

#include <array>
#include <vector>

namespace porefines::flow {

namespace {

constexpr int width = grid::line_width;

/// Stencil coefficients of component c in row (j, k): along x they vary, across they do not.
template <int c>
struct RowStencil {
  const float* x_low;
  const float* x_high;
  const float* x_gradient;
  float y_low, y_high, z_low, z_high, gradient;

  RowStencil(const Level& level, int j, int k) {
    const auto& [ax, ay, az] = level.axis;
    const int jj = j + ay.offset;
    const int kk = k + az.offset;
    x_low = (c == 0 ? ax.face_low : ax.cell_low).data() + ax.offset;
    x_high = (c == 0 ? ax.face_high : ax.cell_high).data() + ax.offset;
    x_gradient = ax.gradient.data() + ax.offset;
    y_low = (c == 1 ? ay.face_low : ay.cell_low)[jj];
    y_high = (c == 1 ? ay.face_high : ay.cell_high)[jj];
    z_low = (c == 2 ? az.face_low : az.cell_low)[kk];
    z_high = (c == 2 ? az.face_high : az.cell_high)[kk];
    gradient = c == 1 ? ay.gradient[jj] : c == 2 ? az.gradient[kk] : 0.0F;
  }
};

/// Lanes of one colour: even ones, odd ones.
struct Lanes {
  alignas(64) std::array<std::array<float, width>, 2> of{};
  constexpr Lanes() {
    for (int l = 0; l < width; ++l) {
      of[l & 1][l] = 1.0F;
    }
  }
};
constexpr Lanes lanes;

/// u = relaxed on the lanes of one colour. Apart from the stencil, so that both loops vectorise.
inline void keep_colour(float* __restrict u, const float* __restrict relaxed, int parity) {
  const float* chosen = lanes.of[parity].data();
#pragma omp simd
  for (int l = 0; l < width; ++l) {
    u[l] = chosen[l] != 0 ? relaxed[l] : u[l];
  }
}

/// Which lanes of a line starting at local x index i belong to the colour: (lane & 1) == parity.
int lane_parity(const grid::Block& b, int i, int j, int k, int colour) {
  return (i + j + k + b.parity() + colour) & 1;
}

template <int c, bool weighted>
void relax_line(Level& level, const RowStencil<c>& s, int i, std::ptrdiff_t at, int parity) {
  const std::ptrdiff_t sy = level.block.sy;
  const std::ptrdiff_t sz = level.block.sz;
  const std::ptrdiff_t sc = c == 0 ? 1 : c == 1 ? sy : sz;
  float* u = level.u[c].data() + at;
  const float* p = level.p.data() + at;
  const float* f = level.f[c].data() + at;
  const float* inverse = level.inverse_diagonal[c].data() + at;
  const float* weight = weighted ? level.weight[c].data() + at : nullptr;
  const float* x_low = s.x_low + i;
  const float* x_high = s.x_high + i;
  const float* x_gradient = s.x_gradient + i;
  alignas(64) std::array<float, width> relaxed;
#pragma omp simd
  for (int l = 0; l < width; ++l) {
    float pull = (p[l] - p[l - sc]) * (c == 0 ? x_gradient[l] : s.gradient);
    if constexpr (weighted) {
      pull *= weight[l];
    }
    const float neighbours = x_low[l] * u[l - 1] + x_high[l] * u[l + 1] + s.y_low * u[l - sy] +
                             s.y_high * u[l + sy] + s.z_low * u[l - sz] + s.z_high * u[l + sz];
    relaxed[l] = inverse[l] * (f[l] - pull + neighbours);
  }
  keep_colour(u, relaxed.data(), parity);
}

template <bool weighted>
void relax_rows(Level& level, int k, RowRange rows, int colour) {
  for (int j = rows.first; j < rows.last; ++j) {
    const RowStencil<0> s0(level, j, k);
    const RowStencil<1> s1(level, j, k);
    const RowStencil<2> s2(level, j, k);
    for_lines(level, j, k, [&](int i) {
      const std::ptrdiff_t at = level.block.at(i, j, k);
      const int parity = lane_parity(level.block, i, j, k, colour);
      if (level.flows[0]) {
        relax_line<0, weighted>(level, s0, i, at, parity);
      }
      if (level.flows[1]) {
        relax_line<1, weighted>(level, s1, i, at, parity);
      }
      if (level.flows[2]) {
        relax_line<2, weighted>(level, s2, i, at, parity);
      }
    });
  }
}

template <int c>
void relax_component_rows(Level& level, int k, RowRange rows, int colour, float omega) {
  const std::ptrdiff_t sy = level.block.sy;
  const std::ptrdiff_t sz = level.block.sz;
  for (int j = rows.first; j < rows.last; ++j) {
    const RowStencil<c> s(level, j, k);
    for_lines(level, j, k, [&](int i) {
      const std::ptrdiff_t at = level.block.at(i, j, k);
      const int parity = lane_parity(level.block, i, j, k, colour);
      float* u = level.u[c].data() + at;
      const float* f = level.f[c].data() + at;
      const float* inverse = level.inverse_diagonal[c].data() + at;
      alignas(64) std::array<float, width> moved;
#pragma omp simd
      for (int l = 0; l < width; ++l) {
        const float neighbours = s.x_low[i + l] * u[l - 1] + s.x_high[i + l] * u[l + 1] +
                                 s.y_low * u[l - sy] + s.y_high * u[l + sy] + s.z_low * u[l - sz] +
                                 s.z_high * u[l + sz];
        moved[l] = u[l] + omega * (inverse[l] * (f[l] + neighbours) - u[l]);
      }
      keep_colour(u, moved.data(), parity);
    });
  }
}

/// Coefficients of divergence and gradient in row (j, k) of cells.
struct PushStencil {
  const float* div_x;
  const float* grad_x;
  float div_y, div_z, grad_y_low, grad_y_high, grad_z_low, grad_z_high;

  PushStencil(const Level& level, int j, int k) {
    const auto& [ax, ay, az] = level.axis;
    div_x = ax.divergence.data() + ax.offset;
    grad_x = ax.gradient.data() + ax.offset;
    div_y = ay.divergence[j + ay.offset];
    div_z = az.divergence[k + az.offset];
    grad_y_low = ay.gradient[j + ay.offset];
    grad_y_high = ay.gradient[j + 1 + ay.offset];
    grad_z_low = az.gradient[k + az.offset];
    grad_z_high = az.gradient[k + 1 + az.offset];
  }
};

/// W u at a face.
template <bool weighted>
inline float flux(const float* u, const float* weight, std::ptrdiff_t at) {
  if constexpr (weighted) {
    return weight[at] * u[at];
  } else {
    return u[at];
  }
}

/// flat: nothing flows along z.
template <bool weighted, bool flat>
void push_line_cells(Level& level, const PushStencil& s, int i, std::ptrdiff_t at, int parity,
                     float omega, float* moved) {
  const std::ptrdiff_t sy = level.block.sy;
  const std::ptrdiff_t sz = level.block.sz;
  const float* u = level.u[0].data() + at;
  const float* v = level.u[1].data() + at;
  const float* w = level.u[2].data() + at;
  const float* wu = weighted ? level.weight[0].data() + at : nullptr;
  const float* wv = weighted ? level.weight[1].data() + at : nullptr;
  const float* ww = weighted ? level.weight[2].data() + at : nullptr;
  const float* g = level.g.data() + at;
  const float* push = level.push.data() + at;
  float* p = level.p.data() + at;
  const float* div_x = s.div_x + i;
  const float* chosen = lanes.of[parity].data();
#pragma omp simd
  for (int l = 0; l < width; ++l) {
    float divergence = (flux<weighted>(u, wu, l + 1) - flux<weighted>(u, wu, l)) * div_x[l] +
                       (flux<weighted>(v, wv, l + sy) - flux<weighted>(v, wv, l)) * s.div_y;
    if constexpr (!flat) {
      divergence += (flux<weighted>(w, ww, l + sz) - flux<weighted>(w, ww, l)) * s.div_z;
    }
    const float q = chosen[l] * push[l] * (g[l] - divergence);
    p[l] += omega * q;
    moved[l] = q;
  }
}

/// u -= sign (W/d) grad q on one line of faces.
template <bool weighted>
inline void push_faces(float* u, const float* inverse, const float* weight, const float* q,
                       float step) {
#pragma omp simd
  for (int l = 0; l < width; ++l) {
    const float mobility = weighted ? inverse[l] * weight[l] : inverse[l];
    u[l] -= mobility * step * q[l];
  }
}

template <bool weighted, bool flat>
void push_line_faces(Level& level, const PushStencil& s, int i, std::ptrdiff_t at, const float* q) {
  const std::ptrdiff_t sy = level.block.sy;
  const std::ptrdiff_t sz = level.block.sz;
  const auto& inverse = level.inverse_diagonal;
  const auto weight = [&](int c, std::ptrdiff_t where) {
    return weighted ? level.weight[c].data() + where : nullptr;
  };
  float* u = level.u[0].data() + at;
  const float* grad_x = s.grad_x + i;
  const float* inverse_u = inverse[0].data() + at;
  const float* weight_u = weight(0, at);
#pragma omp simd
  for (int l = 0; l < width; ++l) {
    const float mobility = weighted ? inverse_u[l] * weight_u[l] : inverse_u[l];
    u[l] -= mobility * grad_x[l] * (q[l] - q[l - 1]);
  }
  const auto faces = [&](int c, std::ptrdiff_t where, float step) {
    push_faces<weighted>(level.u[c].data() + where, inverse[c].data() + where, weight(c, where), q,
                         step);
  };
  faces(1, at, s.grad_y_low);
  faces(1, at + sy, -s.grad_y_high);
  if constexpr (!flat) {
    faces(2, at, s.grad_z_low);
    faces(2, at + sz, -s.grad_z_high);
  }
}

template <bool weighted, bool flat>
void push_rows(Level& level, int k, RowRange rows, int colour, float omega) {
  const grid::Block& b = level.block;
  static thread_local std::vector<float> buffer;
  buffer.assign(static_cast<std::size_t>(b.sy) + 2 * width, 0.0F);
  float* moved = buffer.data() + width + b.ghost[0];  // index = local x
  for (int j = rows.first; j < rows.last; ++j) {
    const PushStencil s(level, j, k);
    for_lines(level, j, k, [&](int i) {
      push_line_cells<weighted, flat>(level, s, i, b.at(i, j, k), lane_parity(b, i, j, k, colour),
                                      omega, moved + i);
    });
    for_lines(level, j, k, [&](int i) {
      push_line_faces<weighted, flat>(level, s, i, b.at(i, j, k), moved + i);
    });
    for_lines(level, j, k, [&](int i) {
      for (int l = 0; l < width; ++l) {
        moved[i + l] = 0;
      }
    });
  }
}

template <int c, bool weighted>
void residual_line(Level& level, const RowStencil<c>& s, int i, std::ptrdiff_t at) {
  const std::ptrdiff_t sy = level.block.sy;
  const std::ptrdiff_t sz = level.block.sz;
  const std::ptrdiff_t sc = c == 0 ? 1 : c == 1 ? sy : sz;
  const float* u = level.u[c].data() + at;
  const float* p = level.p.data() + at;
  const float* f = level.f[c].data() + at;
  const float* inverse = level.inverse_diagonal[c].data() + at;
  const float* carry = level.carry[c].data() + at;
  const float* weight = weighted ? level.weight[c].data() + at : nullptr;
  float* r = level.residual_of(c) + at;
#pragma omp simd
  for (int l = 0; l < width; ++l) {
    float pull = (p[l] - p[l - sc]) * (c == 0 ? s.x_gradient[i + l] : s.gradient);
    if constexpr (weighted) {
      pull *= weight[l];
    }
    const float neighbours = s.x_low[i + l] * u[l - 1] + s.x_high[i + l] * u[l + 1] +
                             s.y_low * u[l - sy] + s.y_high * u[l + sy] + s.z_low * u[l - sz] +
                             s.z_high * u[l + sz];
    const float residual = f[l] - pull + neighbours - u[l] / inverse[l];
    r[l] = inverse[l] != 0 ? carry[l] * residual : 0.0F;
  }
}

template <bool weighted, bool flat>
void residual_rows(Level& level, int k, RowRange rows) {
  const grid::Block& b = level.block;
  for (int j = rows.first; j < rows.last; ++j) {
    const RowStencil<0> s0(level, j, k);
    const RowStencil<1> s1(level, j, k);
    const RowStencil<2> s2(level, j, k);
    const PushStencil s(level, j, k);
    for_lines(level, j, k, [&](int i) {
      const std::ptrdiff_t at = b.at(i, j, k);
      residual_line<0, weighted>(level, s0, i, at);
      residual_line<1, weighted>(level, s1, i, at);
      if constexpr (!flat) {
        residual_line<2, weighted>(level, s2, i, at);
      }
      const float* u = level.u[0].data() + at;
      const float* v = level.u[1].data() + at;
      const float* w = level.u[2].data() + at;
      const float* wu = weighted ? level.weight[0].data() + at : nullptr;
      const float* wv = weighted ? level.weight[1].data() + at : nullptr;
      const float* ww = weighted ? level.weight[2].data() + at : nullptr;
      const float* g = level.g.data() + at;
      const float* push = level.push.data() + at;
      float* rg = level.residual_of(3) + at;
#pragma omp simd
      for (int l = 0; l < width; ++l) {
        float divergence =
            (flux<weighted>(u, wu, l + 1) - flux<weighted>(u, wu, l)) * s.div_x[i + l] +
            (flux<weighted>(v, wv, l + b.sy) - flux<weighted>(v, wv, l)) * s.div_y;
        if constexpr (!flat) {
          divergence += (flux<weighted>(w, ww, l + b.sz) - flux<weighted>(w, ww, l)) * s.div_z;
        }
        rg[l] = push[l] != 0 ? g[l] - divergence : 0.0F;
      }
    });
  }
}

}  // namespace

void relax_velocity(Level& level, int k, RowRange rows, int colour) {
  level.weighted() ? relax_rows<true>(level, k, rows, colour)
                   : relax_rows<false>(level, k, rows, colour);
}

void relax_component(Level& level, int component, int k, RowRange rows, int colour, float omega) {
  component == 0   ? relax_component_rows<0>(level, k, rows, colour, omega)
  : component == 1 ? relax_component_rows<1>(level, k, rows, colour, omega)
                   : relax_component_rows<2>(level, k, rows, colour, omega);
}

void push_pressure(Level& level, int k, RowRange rows, int colour, float omega) {
  if (level.flows[2]) {
    level.weighted() ? push_rows<true, false>(level, k, rows, colour, omega)
                     : push_rows<false, false>(level, k, rows, colour, omega);
  } else {
    level.weighted() ? push_rows<true, true>(level, k, rows, colour, omega)
                     : push_rows<false, true>(level, k, rows, colour, omega);
  }
}

void find_residual(Level& level, int k, RowRange rows) {
  if (level.flows[2]) {
    level.weighted() ? residual_rows<true, false>(level, k, rows)
                     : residual_rows<false, false>(level, k, rows);
  } else {
    level.weighted() ? residual_rows<true, true>(level, k, rows)
                     : residual_rows<false, true>(level, k, rows);
  }
}

}  // namespace porefines::flow
