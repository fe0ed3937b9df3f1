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
  std::vector<Index> first_;  ///< per cell: where its list starts
  std::vector<std::int32_t> list_;
};

using SphereList = RoundBodies<3>;
using CylinderList = RoundBodies<2>;

/// Coordinate inside the sample that stands for x along an axis; unchanged beyond an open face.
[[nodiscard]] Real fold(Real x, Real size, Beyond beyond);

/// Rows `x y z r` (dims 3) or `x y r` (dims 2), numbers apart by blanks, commas or semicolons.
///
/// '#' starts a comment; leading lines that are not rows are taken as header.
/// @param unit  [m] of the numbers
/// Errors: InputError with the line number for a bad row, a radius that is not positive, no rows.
[[nodiscard]] std::vector<Body> read_bodies(const std::string& path, int dims, Real unit);

}  // namespace porefines::geom
