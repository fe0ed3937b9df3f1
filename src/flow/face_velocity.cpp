// SPDX-License-Identifier: MPL-2.0
#include "flow/face_velocity.hpp"

namespace porefines::flow {

FaceVelocity::FaceVelocity(const Level& level, const Boundaries& boundaries)
    : boundaries_(boundaries), pad_(2 * level.block.sz + grid::line_width) {
  for (Floats& field : field_) {
    field.assign(level.block.size + 2 * static_cast<std::size_t>(pad_), 0.0F);
  }
}

template <typename T>
void FaceVelocity::load(Level& level, const Operator& op, const Packed<T>& values,
                        const std::array<Real, 6>& inlet, const FaceVelocity& carrier) {
  op.for_each_line([&](int i, int j, int k, std::size_t from) {
    const std::ptrdiff_t to = level.block.at(i, j, k);
    for (int c = 0; c < 3; ++c) {
      const T* packed = values.data() + from + c * grid::line_width;
      float* line = data(c) + to;
      for (int l = 0; l < grid::line_width; ++l) {
        line[l] = static_cast<float>(packed[l]);
      }
    }
  });
  const std::array<float*, 3> fields{data(0), data(1), data(2)};
  level.halo.exchange(fields, 2);
  const grid::Block& b = level.block;
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool high : {false, true}) {
      const bool at_end = high ? b.start[axis] + b.n[axis] == b.global[axis] : b.start[axis] == 0;
      if (at_end && !boundaries_.periodic(axis)) {
        fill_side(level, axis, high, inlet, carrier);
      }
    }
  }
}

void FaceVelocity::fill_side(const Level& level, int axis, bool high,
                             const std::array<Real, 6>& inlet, const FaceVelocity& carrier) {
  const FaceKind kind = boundaries_.at(axis, high);
  const grid::Block& b = level.block;
  const std::ptrdiff_t s = b.stride(axis);
  const int boundary = high ? b.n[axis] : 0;  // face
  if (kind == FaceKind::velocity) {
    const auto value = static_cast<float>(inlet[2 * axis + (high ? 1 : 0)]);
    const auto& inverse = level.inverse_diagonal[axis];
    grid::for_layer(b, axis, boundary, [&](std::ptrdiff_t at) {
      data(axis)[at] = inverse[at + (high ? -s : s)] != 0 ? value : 0.0F;
    });
  }
  if (kind != FaceKind::velocity && !gives_pressure(kind)) {
    return;  // no flow through the face: whatever lies beyond is not carried
  }
  const std::ptrdiff_t inwards = high ? -s : s;
  const float outwards = high ? 1.0F : -1.0F;
  for (int c = 0; c < 3; ++c) {
    if (c == axis) {
      continue;
    }
    const float* through = carrier.data(axis);
    float* u = data(c);
    const std::ptrdiff_t sc = b.stride(c);
    const std::ptrdiff_t face = high ? 0 : s;  // from the cell beyond to the box face
    grid::for_layer(b, axis, high ? b.n[axis] : -1, [&](std::ptrdiff_t at) {
      const float inside = u[at + inwards];
      if (kind != FaceKind::outflow) {
        u[at] = -inside;
      } else {
        const bool leaves = outwards * (through[at + face] + through[at + face - sc]) > 0;
        u[at] = leaves ? inside : 0.0F;
      }
    });
  }
}

template void FaceVelocity::load<float>(Level&, const Operator&, const Packed<float>&,
                                        const std::array<Real, 6>&, const FaceVelocity&);
template void FaceVelocity::load<double>(Level&, const Operator&, const Packed<double>&,
                                         const std::array<Real, 6>&, const FaceVelocity&);

}  // namespace porefines::flow
