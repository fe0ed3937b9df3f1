// SPDX-License-Identifier: MPL-2.0
#include "flow/operator.hpp"

#include <algorithm>

#include "flow/rigid_spheres.hpp"

namespace porefines::flow {

namespace {

constexpr int width = grid::line_width;

template <int c, typename T>
void momentum_line(const Level& level, const Friction& friction, int i, int j, int k, T* out) {
  const auto& [ax, ay, az] = level.axis;
  const std::ptrdiff_t sy = level.block.sy;
  const std::ptrdiff_t sz = level.block.sz;
  const std::ptrdiff_t sc = c == 0 ? 1 : c == 1 ? sy : sz;
  const std::ptrdiff_t at = level.block.at(i, j, k);
  const float* u = level.u[c].data() + at;
  const float* p = level.p.data() + at;
  const float* excess = friction.excess[c].data() + at;
  const float* weight = level.weight[c].data() + at;
  const int ii = i + ax.offset;
  const int jj = j + ay.offset;
  const int kk = k + az.offset;
  const float* x_low = (c == 0 ? ax.face_low : ax.cell_low).data() + ii;
  const float* x_high = (c == 0 ? ax.face_high : ax.cell_high).data() + ii;
  const double y_low = (c == 1 ? ay.face_low : ay.cell_low)[jj];
  const double y_high = (c == 1 ? ay.face_high : ay.cell_high)[jj];
  const double z_low = (c == 2 ? az.face_low : az.cell_low)[kk];
  const double z_high = (c == 2 ? az.face_high : az.cell_high)[kk];
  const double gradient = c == 1 ? ay.gradient[jj] : c == 2 ? az.gradient[kk] : 0.0;
  const float* x_gradient = ax.gradient.data() + ii;
  const float* owned_x = (c == 0 ? ax.owned_face : ax.owned_cell).data() + ii;
  const float owned_row =
      (c == 1 ? ay.owned_face : ay.owned_cell)[jj] * (c == 2 ? az.owned_face : az.owned_cell)[kk];
#pragma omp simd
  for (int l = 0; l < width; ++l) {
    const double here = u[l];
    const double friction_here = static_cast<double>(x_low[l]) * (here - u[l - 1]) +
                                 static_cast<double>(x_high[l]) * (here - u[l + 1]) +
                                 y_low * (here - u[l - sy]) + y_high * (here - u[l + sy]) +
                                 z_low * (here - u[l - sz]) + z_high * (here - u[l + sz]) +
                                 static_cast<double>(excess[l]) * here;
    const double pull = static_cast<double>(weight[l]) * (c == 0 ? x_gradient[l] : gradient) *
                        (static_cast<double>(p[l]) - p[l - sc]);
    const bool real = owned_x[l] * owned_row != 0 && excess[l] < Friction::inactive;
    out[l] = static_cast<T>(real ? friction_here + pull : 0.0);
  }
}

template <typename T>
void continuity_line(const Level& level, int i, int j, int k, T* out) {
  const auto& [ax, ay, az] = level.axis;
  const std::ptrdiff_t sy = level.block.sy;
  const std::ptrdiff_t sz = level.block.sz;
  const std::ptrdiff_t at = level.block.at(i, j, k);
  const float* u = level.u[0].data() + at;
  const float* v = level.u[1].data() + at;
  const float* w = level.u[2].data() + at;
  const float* wu = level.weight[0].data() + at;
  const float* wv = level.weight[1].data() + at;
  const float* ww = level.weight[2].data() + at;
  const float* push = level.push.data() + at;
  const float* div_x = ax.divergence.data() + i + ax.offset;
  const double div_y = ay.divergence[j + ay.offset];
  const double div_z = az.divergence[k + az.offset];
  const float* owned_x = ax.owned_cell.data() + i + ax.offset;
  const float owned_row = ay.owned_cell[j + ay.offset] * az.owned_cell[k + az.offset];
  const auto flux = [](const float* weight, const float* field, std::ptrdiff_t l) {
    return static_cast<double>(weight[l]) * field[l];
  };
#pragma omp simd
  for (int l = 0; l < width; ++l) {
    const double divergence = (flux(wu, u, l + 1) - flux(wu, u, l)) * div_x[l] +
                              (flux(wv, v, l + sy) - flux(wv, v, l)) * div_y +
                              (flux(ww, w, l + sz) - flux(ww, w, l)) * div_z;
    const bool real = owned_x[l] * owned_row != 0 && push[l] != 0;
    out[l] = static_cast<T>(real ? divergence : 0.0);
  }
}

}  // namespace

Operator::Operator(Level& level, const Friction& friction) : level_(level), friction_(friction) {
  const grid::Block& b = level.block;
  line_at_.assign(b.size / width, -1);
  for (int k = 0; k < b.n[2] + (b.owns_end[2] ? 1 : 0); ++k) {
    for (int j = 0; j < b.n[1] + (b.owns_end[1] ? 1 : 0); ++j) {
      for_lines(level, j, k, [&](int i) {
        if (i + width > 0 && i < b.n[0] + (b.owns_end[0] ? 1 : 0)) {
          line_at_[b.at(i, j, k) / width] = static_cast<std::int32_t>(lines_.size());
          lines_.push_back({i, j, k});
        }
      });
    }
  }
}

void Operator::attach(RigidSpheres* spheres) {
  spheres_ = spheres;
  tail_ = spheres != nullptr ? spheres->tail() : 0;
}

std::size_t Operator::position(int component, const Int3& index) const {
  const std::ptrdiff_t at = level_.block.at(index[0], index[1], index[2]);
  const std::ptrdiff_t lane = (index[0] + level_.block.ghost[0]) % width;
  return static_cast<std::size_t>(line_at_[(at - lane) / width]) * packed_width +
         static_cast<std::size_t>(component * width + lane);
}

template <typename T>
void Operator::apply(Packed<T>& out) {
  level_.exchange_unknowns(1);
  for (std::size_t line = 0; line < lines_.size(); ++line) {
    const auto [i, j, k] = lines_[line];
    T* to = out.data() + line * packed_width;
    momentum_line<0>(level_, friction_, i, j, k, to);
    momentum_line<1>(level_, friction_, i, j, k, to + width);
    if (level_.flows[2]) {
      momentum_line<2>(level_, friction_, i, j, k, to + 2 * width);
    } else {
      std::fill_n(to + 2 * width, width, T{0});
    }
    continuity_line(level_, i, j, k, to + 3 * width);
  }
  if (spheres_ != nullptr) {
    spheres_->apply(out.data(), out.data() + fluid_size());
  }
}

template void Operator::apply<float>(Packed<float>&);
template void Operator::apply<double>(Packed<double>&);

void Operator::residual(const Packed<float>& b, const Packed<double>& x, Packed<float>& r) {
  Packed<float> part(size());
  Packed<double> image(size());
  for (std::size_t at = 0; at < size(); ++at) {
    part[at] = static_cast<float>(x[at]);
  }
  load_unknowns(part);
  apply(image);
  for (std::size_t at = 0; at < size(); ++at) {
    r[at] = static_cast<float>(b[at] - image[at]);
    part[at] = static_cast<float>(x[at] - static_cast<double>(part[at]));
  }
  load_unknowns(part);
  apply(image);
  for (std::size_t at = 0; at < size(); ++at) {
    r[at] = static_cast<float>(r[at] - image[at]);
  }
}

template <typename T>
void Operator::scatter(const std::array<Floats*, 4>& fields, const Packed<T>& v, double scale) {
  for (std::size_t line = 0; line < lines_.size(); ++line) {
    const auto [i, j, k] = lines_[line];
    const std::ptrdiff_t to = level_.block.at(i, j, k);
    for (int c = 0; c < 4; ++c) {
      const T* from = v.data() + line * packed_width + c * width;
      for (int l = 0; l < width; ++l) {
        (*fields[c])[to + l] = static_cast<float>(scale * from[l]);
      }
    }
  }
}

template <typename T>
void Operator::load_right_hand_side(const Packed<T>& v, double scale) {
  scatter({&level_.f[0], &level_.f[1], &level_.f[2], &level_.g}, v, scale);
  if (spheres_ != nullptr) {
    spheres_->load_force(v.data() + fluid_size(), scale);
  }
}

template void Operator::load_right_hand_side<float>(const Packed<float>&, double);
template void Operator::load_right_hand_side<double>(const Packed<double>&, double);

template <typename T>
void Operator::load_unknowns(const Packed<T>& v) {
  scatter({&level_.u[0], &level_.u[1], &level_.u[2], &level_.p}, v, 1);
  if (spheres_ != nullptr) {
    spheres_->load_motion(v.data() + fluid_size());
  }
}

template void Operator::load_unknowns<float>(const Packed<float>&);
template void Operator::load_unknowns<double>(const Packed<double>&);

template <typename T>
void Operator::store_unknowns(Packed<T>& v) const {
  const std::array<const Floats*, 4> fields{&level_.u[0], &level_.u[1], &level_.u[2], &level_.p};
  const auto& axis = level_.axis;
  for (std::size_t line = 0; line < lines_.size(); ++line) {
    const auto [i, j, k] = lines_[line];
    const std::ptrdiff_t from = level_.block.at(i, j, k);
    for (int c = 0; c < 4; ++c) {
      const auto owned = [&](int a) -> const std::vector<float>& {
        return a == c ? axis[a].owned_face : axis[a].owned_cell;
      };
      const float row = owned(1)[j + axis[1].offset] * owned(2)[k + axis[2].offset];
      const float* owned_x = owned(0).data() + i + axis[0].offset;
      T* to = v.data() + line * packed_width + c * width;
      const float* field = fields[c]->data() + from;
      for (int l = 0; l < width; ++l) {
        to[l] = static_cast<T>(field[l] * (owned_x[l] * row));
      }
    }
  }
  if (spheres_ != nullptr) {
    spheres_->store_motion(v.data() + fluid_size());
  }
}

template void Operator::store_unknowns<float>(Packed<float>&) const;
template void Operator::store_unknowns<double>(Packed<double>&) const;

}  // namespace porefines::flow
