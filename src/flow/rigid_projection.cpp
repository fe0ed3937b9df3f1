// SPDX-License-Identifier: MPL-2.0
#include "flow/rigid_projection.hpp"

#include <algorithm>
#include <cmath>

#include "par/gather.hpp"

namespace porefines::flow {

/// Calls visit(row, share that is inside, velocity unknown [inner units]) for this rank's faces in the
/// sphere whose centre is given [cells from the corner of the block].
template <typename Visit>
void RigidProjection::for_faces_at(const Vec3& centre, Real radius, const Visit& visit) const {
  const Level& level = parts_.hierarchy.finest();
  const grid::Block& b = level.block;
  const Vec3& h = parts_.spacing;
  Int3 first{};
  Int3 last{};
  for (int a = 0; a < 3; ++a) {
    const Real cells = radius / h[a] + 0.5;
    first[a] = std::max(0, static_cast<int>(std::floor(centre[a] - cells)));
    last[a] = std::min(b.n[a], static_cast<int>(std::ceil(centre[a] + cells)));
  }
  for (int c = 0; c < 3; ++c) {
    grid::for_window(first, last, [&](const Int3& index) {
      Vec3 arm;  // [m]
      for (int a = 0; a < 3; ++a) {
        arm[a] = (index[a] + (a == c ? 0.0 : 0.5) - centre[a]) * h[a];
      }
      const std::ptrdiff_t at = b.at(index[0], index[1], index[2]);
      const Real share = std::clamp(0.5 + (radius - norm(arm)) / h.x, 0.0, 1.0);
      if (share > 0 && level.owns(c, index) && level.inverse_diagonal[c][at] != 0) {
        visit(row_of(c, arm), share, parts_.unknowns[parts_.equations.position(c, index)]);
      }
    });
  }
}

/// The same for a sphere and its periodic images.
template <typename Visit>
void RigidProjection::for_faces(const Sphere& sphere, const Visit& visit) const {
  const grid::Block& b = parts_.hierarchy.finest().block;
  Int3 wraps{};
  for (int a = 0; a < 3; ++a) {
    wraps[a] = parts_.boundaries.periodic(a) ? 1 : 0;
  }
  grid::for_window({-wraps[0], -wraps[1], -wraps[2]}, wraps, [&](const Int3& image) {
    Vec3 centre;
    for (int a = 0; a < 3; ++a) {
      centre[a] = sphere.position[a] / parts_.spacing[a] + image[a] * b.global[a] - b.start[a];
    }
    for_faces_at(centre, sphere.radius, visit);
  });
}

/// Cholesky factors of sum r r^T over the faces of each sphere: its masses and moments in faces.
std::vector<SixBySix> RigidProjection::gather_moments(const std::vector<Sphere>& all) const {
  std::vector<Real> sums(36 * all.size(), 0);
  for (std::size_t q = 0; q < all.size(); ++q) {
    for_faces(all[q], [&](const Six& row, Real share, const double&) {
      for (std::size_t i = 0; i < 36; ++i) {
        sums[36 * q + i] += share * row[i / 6] * row[i % 6];
      }
    });
  }
  comm_.sum(sums);
  std::vector<SixBySix> factors(all.size());
  for (std::size_t q = 0; q < all.size(); ++q) {
    std::copy_n(&sums[36 * q], 36, factors[q].begin());
    factors[q] = cholesky(factors[q]);
  }
  return factors;
}

void RigidProjection::kick(Real step, const std::vector<Sphere>& all,
                           const std::vector<SixBySix>& factors) {
  const Vec3& h = parts_.spacing;
  const Real unit = parts_.velocity_unit();
  const Real face_mass = density_ * h.x * h.y * h.z;
  for (std::size_t q = 0; q < all.size(); ++q) {
    const Sphere& s = all[q];
    const Six push{s.force.x, s.force.y, s.force.z, s.torque.x, s.torque.y, s.torque.z};
    const Six change = solved(factors[q], push);  // of the motion, times the mass of a face
    for_faces(s, [&](const Six& row, Real share, double& u) {
      u += share * step / face_mass * dot(row, change) / unit;
    });
  }
}

std::vector<Six> RigidProjection::fit(const std::vector<Sphere>& all,
                                      const std::vector<SixBySix>& factors) const {
  const Real unit = parts_.velocity_unit();
  std::vector<Real> sums(6 * all.size(), 0);
  for (std::size_t q = 0; q < all.size(); ++q) {
    for_faces(all[q], [&](const Six& row, Real share, const double& u) {
      for (std::size_t x = 0; x < 6; ++x) {
        sums[6 * q + x] += share * row[x] * u * unit;
      }
    });
  }
  comm_.sum(sums);
  std::vector<Six> motions(all.size());
  for (std::size_t q = 0; q < all.size(); ++q) {
    const Sphere& s = all[q];
    std::copy_n(&sums[6 * q], 6, motions[q].begin());
    motions[q] = s.held
                     ? Six{s.velocity.x, s.velocity.y, s.velocity.z, s.spin.x, s.spin.y, s.spin.z}
                     : solved(factors[q], motions[q]);
  }
  return motions;
}

void RigidProjection::put(const std::vector<Sphere>& all, const std::vector<Six>& motions) {
  const Real unit = parts_.velocity_unit();
  for (std::size_t q = 0; q < all.size(); ++q) {
    for_faces(all[q], [&](const Six& row, Real share, double& u) {
      u += share * (dot(row, motions[q]) / unit - u);
    });
  }
}

std::vector<SphereMotion> RigidProjection::advance(Real step, const Drive& drive,
                                                   const std::vector<Sphere>& owned,
                                                   const StepOptions& options) {
  std::vector<Sphere> all = par::gather(comm_, owned);
  par::broadcast(comm_, all);
  const std::vector<SixBySix> factors = gather_moments(all);
  kick(step, all, factors);
  last_ = flow_.advance(step, drive, options);
  const std::vector<Six> motions = fit(all, factors);
  put(all, motions);
  std::vector<SphereMotion> out;
  for (const Sphere& s : owned) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Sphere& other) { return other.id == s.id; });
    const Six& v = motions[static_cast<std::size_t>(found - all.begin())];
    out.push_back({{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, s.force, s.torque, {}});
  }
  return out;
}

}  // namespace porefines::flow
