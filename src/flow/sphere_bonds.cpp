// SPDX-License-Identifier: MPL-2.0
// RigidSpheres: motions of spheres that lubrication binds together.
#include <cmath>

#include "flow/rigid_spheres.hpp"

namespace porefines::flow {

namespace {

constexpr Real wanted = 0.03;  ///< relative residual: the fluid changes more in the next sweep
constexpr int most = 40;

}  // namespace

/// Over the balls of all ranks.
Real RigidSpheres::dot_owned(const std::vector<Six>& a, const std::vector<Six>& b) const {
  Real sum = 0;
  for (std::size_t ball = 0; ball < set_.owned(); ++ball) {
    sum += dot(a[ball], b[ball]);
  }
  return comm_.sum(sum);
}

/// (blocks alone + lubrication) v; rows of held balls are zero.
std::vector<Six> RigidSpheres::times_matrix(const std::vector<Six>& v) {
  std::vector<Six> pull(set_.size(), Six{});
  for (const Lubrication& gap : gaps_) {
    add_lubrication(gap, v, 1 / set_.cell_volume(), pull);
  }
  set_.sum(pull);
  std::vector<Six> out(set_.size(), Six{});
  for (std::size_t ball = 0; ball < set_.size(); ++ball) {
    if (!set_.balls()[ball].held) {
      out[ball] = times(alone_[ball], v[ball]);
      for (std::size_t x = 0; x < 6; ++x) {
        out[ball][x] -= pull[ball][x];
      }
    }
  }
  return out;
}

/// Conjugate gradients with the diagonal blocks as preconditioner; without bonds these are exact.
std::vector<Six> RigidSpheres::solve_together(std::vector<Six> rest) {
  const auto precondition = [&](const std::vector<Six>& r) {
    std::vector<Six> z(set_.size());
    for (std::size_t ball = 0; ball < set_.size(); ++ball) {
      z[ball] = times(inverse_[ball], r[ball]);
    }
    return z;
  };
  std::vector<Six> z = precondition(rest);
  if (!bound_) {
    return z;
  }
  std::vector<Six> change(set_.size(), Six{});
  std::vector<Six> direction = z;
  const auto step = [](std::vector<Six>& to, Real factor, const std::vector<Six>& by) {
    for (std::size_t ball = 0; ball < to.size(); ++ball) {
      for (std::size_t x = 0; x < 6; ++x) {
        to[ball][x] += factor * by[ball][x];
      }
    }
  };
  Real square = dot_owned(rest, z);
  const Real enough = wanted * wanted * square;
  for (int iteration = 0; iteration < most && square > enough; ++iteration) {
    const std::vector<Six> image = times_matrix(direction);
    const Real length = square / dot_owned(direction, image);
    step(change, length, direction);
    step(rest, -length, image);
    z = precondition(rest);
    const Real before = square;
    square = dot_owned(rest, z);
    std::vector<Six> next = z;
    step(next, square / before, direction);
    direction = std::move(next);
  }
  return change;
}

}  // namespace porefines::flow
