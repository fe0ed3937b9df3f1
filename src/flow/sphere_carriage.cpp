// SPDX-License-Identifier: MPL-2.0
#include "flow/sphere_carriage.hpp"

#include <cstdlib>
#include <map>
#include <utility>

namespace porefines::flow {

SphereCarriage::Side SphereCarriage::side_of(const SphereLink& link, const Int3& index) const {
  const grid::Block& b = level_.block;
  const int t = std::abs(link.towards) - 1;
  const int sign = link.towards > 0 ? 1 : -1;
  const bool along = t == link.face.component;
  const auto& axis = level_.axis[t];
  const auto& low = along ? axis.face_low : axis.cell_low;
  const auto& high = along ? axis.face_high : axis.cell_high;
  const float theta = (sign < 0 ? low : high)[index[t] + axis.offset] / link.friction;
  Side q;
  q.face = link.face;
  q.packed = link.packed;
  q.axis = t;
  q.beyond = sign * b.stride(t);
  q.first = along == (sign > 0) ? 0 : sign * b.stride(t);
  q.across = along ? b.stride(t) : -b.stride(link.face.component);
  q.back = (1 - theta) / (1 + theta);
  q.share = static_cast<float>(sign * 0.5 / level_.widths[t].front());
  return q;
}

void SphereCarriage::place(const RigidSpheres& spheres) {
  sides_.clear();
  for (std::size_t ball = 0; ball < spheres.set().size(); ++ball) {
    for (const SphereLink& link : spheres.cover().cuts()[ball].links) {
      Side q = side_of(link, spheres.cover().index_of(link.face.at));
      q.ball = static_cast<int>(ball);
      const std::ptrdiff_t behind = static_cast<std::ptrdiff_t>(link.face.at) - q.beyond;
      if (level_.inverse_diagonal[link.face.component][behind] != 0) {
        sides_.push_back(q);
      }
    }
  }
}

float SphereCarriage::missing(const Side& q, const RigidSpheres& spheres,
                              const FaceVelocity& u) const {
  const float* v = u.data(q.face.component) + q.face.at;
  const auto surface = static_cast<float>(q.face.of(spheres.motion()[q.ball]));
  return surface - q.back * (v[-q.beyond] - surface) - v[q.beyond];
}

float SphereCarriage::flux(const Side& q, const FaceVelocity& u) const {
  const std::ptrdiff_t at = q.face.at + q.first;
  const float* v = u.data(q.axis) + at;
  const float* w = level_.weight[q.axis].data() + at;
  return 0.5F * (w[0] * v[0] + w[q.across] * v[q.across]);
}

void SphereCarriage::apply(const RigidSpheres& spheres, const FaceVelocity& u, Packed<float>& out) {
  for (Side& q : sides_) {
    q.miss = missing(q, spheres, u);
    if (q.face.owned) {
      out[q.packed] += q.share * flux(q, u) * q.miss;
    }
  }
}

void SphereCarriage::change(const RigidSpheres& spheres, const FaceVelocity& u,
                            const FaceVelocity& z, Packed<float>& out) const {
  for (const Side& q : sides_) {
    if (q.face.owned) {
      out[q.packed] += q.share * (flux(q, u) * missing(q, spheres, z) + flux(q, z) * q.miss);
    }
  }
}

void SphereCarriage::for_extended(
    const RigidSpheres& spheres, const FaceVelocity& u,
    const std::function<void(int, std::uint32_t, Real)>& visit) const {
  struct Mean {
    Real sum = 0;
    int count = 0;
  };
  std::map<std::pair<int, std::uint32_t>, Mean> found;
  for (const Side& q : sides_) {
    const int c = q.face.component;
    const auto at = static_cast<std::uint32_t>(q.face.at + q.beyond);
    Mean& mean = found[{c, at}];
    mean.sum += u.data(c)[at] + missing(q, spheres, u);
    ++mean.count;
  }
  for (const auto& [face, mean] : found) {
    visit(face.first, face.second, mean.sum / mean.count);
  }
}

}  // namespace porefines::flow
