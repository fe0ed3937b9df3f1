// SPDX-License-Identifier: MPL-2.0
#include "geom/solid.hpp"

namespace porefines::geom {

namespace {

Real distance(const Empty& empty, const Vec3& /*x*/) {
  return empty.band;
}
template <int dims>
Real distance(const RoundBodies<dims>& bodies, const Vec3& x) {
  return bodies.signed_distance(x);
}
Real distance(const VoxelSolid& solid, const Vec3& x) {
  return signed_distance(solid, x);
}

Real band(const Empty& empty) {
  return empty.band;
}
template <int dims>
Real band(const RoundBodies<dims>& bodies) {
  return bodies.band();
}
Real band(const VoxelSolid& solid) {
  return solid.band;
}

}  // namespace

Real signed_distance(const Solid& solid, const Vec3& x) {
  return std::visit([&](const auto& grains) { return distance(grains, x); }, solid);
}

Real band_of(const Solid& solid) {
  return std::visit([](const auto& grains) { return band(grains); }, solid);
}

Vec3 normal(const Solid& solid, const Vec3& x, Real step) {
  Vec3 gradient;
  std::visit(
      [&](const auto& grains) {
        for (int axis = 0; axis < 3; ++axis) {
          Vec3 ahead = x;
          Vec3 behind = x;
          ahead[axis] += step;
          behind[axis] -= step;
          gradient[axis] = distance(grains, ahead) - distance(grains, behind);
        }
      },
      solid);
  const Real length = norm(gradient);
  return length > 0 ? gradient / length : Vec3{};
}

}  // namespace porefines::geom
