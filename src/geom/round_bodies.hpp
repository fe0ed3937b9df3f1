// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

#include "core/types.hpp"
#include "geom/voxels.hpp"

namespace porefines::geom {

/// A sphere, or a cylinder along z (centre.z is then meaningless) [m].
struct Body {
  Vec3 centre;
  Real radius = 0;
};

/// The sample box from the origin to `size` [m], and what lies around it.
struct SampleBox {
  Vec3 size;
  Surroundings beyond{};
};

/// Spheres (dims = 3) or cylinders along z (dims = 2), with a uniform cell list.
///
///     s(x) = min over bodies (|x - c| - r),   clamped to +-band
///
/// exact outside the bodies and inside a single one (inside an overlap it is a lower bound with
/// the right sign). A query looks at one cell only: a body is listed in every cell that comes
/// within band of it. Bodies that reach over a periodic face continue on the other side unless
/// `periodic_images` is off; those that reach over an open face stand in the reservoir.
/// Memory: about (1 + 2 (r + band) / h)^dims entries per body with cells of h ~ r + band.
template <int dims>
class RoundBodies {
 public:
  RoundBodies(const std::vector<Body>& bodies, const SampleBox& box, bool periodic_images,
              Real band);

  [[nodiscard]] Real signed_distance(const Vec3& x) const;
  [[nodiscard]] Real band() const { return band_; }

  /// Calls visit(d, radius, which) for every body or image with |d| - radius < within <= band,
  /// where d [m] points from its centre (or axis) to x and `which` is its place in the list given.
  /// x may lie beyond a mirror; d is then reflected with it.
  template <class Visit>
  void for_each_near(const Vec3& x, Real within, const Visit& visit) const;
  [[nodiscard]] std::size_t size() const { return body_.size(); }  ///< images included

 private:
  [[nodiscard]] int cell_of(Real x, int axis) const;
  template <class Visit>
  void for_each_cell(const Body& body, const Visit& visit) const;

  SampleBox box_;
  Real band_;
  Vec3 low_;       ///< corner of the cell grid [m]
  Real cell_ = 1;  ///< edge of a cell [m]
  Int3 n_{1, 1, 1};
  std::vector<Body> body_;
  std::vector<std::int32_t> which_;  ///< place in the list given, the same for all images
  std::vector<Index> first_;         ///< per cell: where its list starts
  std::vector<std::int32_t> list_;
};

/// Coordinate inside the sample that stands for x along an axis; unchanged beyond an open face.
[[nodiscard]] Real fold(Real x, Real size, Beyond beyond);

template <int dims>
template <class Visit>
void RoundBodies<dims>::for_each_near(const Vec3& x, Real within, const Visit& visit) const {
  Vec3 y = x;
  Vec3 sign{1, 1, 1};
  Int3 cell{0, 0, 0};
  for (int axis = 0; axis < dims; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const Real size = box_.size[axis];
    y[axis] = fold(x[axis], size, box_.beyond[a]);
    if (box_.beyond[a] == Beyond::mirror &&
        x[axis] - 2 * size * std::floor(x[axis] / (2 * size)) >= size) {
      sign[axis] = -1;
    }
    cell[a] = cell_of(y[axis], axis);
    if (cell[a] < 0 || cell[a] >= n_[a]) {
      return;
    }
  }
  const auto place =
      static_cast<std::size_t>(cell[0] + Index{n_[0]} * (cell[1] + Index{n_[1]} * cell[2]));
  for (Index entry = first_[place]; entry < first_[place + 1]; ++entry) {
    const auto b = static_cast<std::size_t>(list_[static_cast<std::size_t>(entry)]);
    Vec3 d = y - body_[b].centre;
    d.z = dims == 2 ? 0 : d.z;
    const Real most = body_[b].radius + within;
    if (most > 0 && dot(d, d) < most * most) {
      visit(Vec3{sign.x * d.x, sign.y * d.y, sign.z * d.z}, body_[b].radius, which_[b]);
    }
  }
}

using SphereList = RoundBodies<3>;
using CylinderList = RoundBodies<2>;

/// Rows `x y z r` (dims 3) or `x y r` (dims 2), numbers apart by blanks, commas or semicolons.
///
/// '#' starts a comment; leading lines that are not rows are taken as header.
/// @param unit  [m] of the numbers
/// Errors: InputError with the line number for a bad row, a radius that is not positive, no rows.
[[nodiscard]] std::vector<Body> read_bodies(const std::string& path, int dims, Real unit);

}  // namespace porefines::geom
