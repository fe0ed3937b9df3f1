// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <vector>

#include "dem/box.hpp"
#include "dem/packing.hpp"
#include "dem/pair_list.hpp"

namespace porefines::dem {

/// Soft frictionless spheres without inertia of their own, on the way to a minimum of
/// E = sum (1/2) overlap^2, overlaps with the walls included.
///
/// Lengths are those of the space; the spring constant and the masses are 1.
class Relaxation {
 public:
  Relaxation(const PackingSpace& space, std::vector<Vec3> position, std::vector<Real> radius);

  /// FIRE until no net force exceeds `balance` times the mean contact force, or until the overlaps
  /// vanish (none over 1e-9 mean diameters).
  /// @return  false: neither within `most` steps
  bool minimise(Real balance, Index most);

  /// All radii times `factor`.
  void scale(Real factor);

  [[nodiscard]] const std::vector<Vec3>& position() const { return position_; }
  [[nodiscard]] const std::vector<Real>& radius() const { return radius_; }
  [[nodiscard]] Real mean_overlap()
      const;                            ///< of those that overlap, over the pair's mean diameter
  [[nodiscard]] Real contacts() const;  ///< per sphere
  [[nodiscard]] Index steps() const { return steps_; }

 private:
  /// A pair that may touch; `image` moves the second next to the first.
  struct Near {
    std::uint32_t first;
    std::uint32_t second;
    Vec3 image;
  };
  struct Loads {
    Real largest_overlap = 0;
    Real overlaps = 0;  ///< sum over contacts
    Real shares = 0;    ///< sum of overlap / mean diameter
    Index pair_contacts = 0;
    Index wall_contacts = 0;
    Real largest_force = 0;  ///< net, on one sphere
  };

  void find_near();
  void refresh_near();
  void find_forces();
  void push_from_walls();

  PackingSpace space_;
  Surfaces walls_;  ///< faces of the space that are not periodic
  std::vector<Vec3> position_;
  std::vector<Real> radius_;
  std::vector<Vec3> velocity_;
  std::vector<Vec3> force_;
  std::vector<Vec3> listed_at_;  ///< positions when the pairs were found
  std::vector<Near> near_;
  Real mean_diameter_ = 0;
  Real skin_ = 0;
  Loads loads_;
  Index steps_ = 0;
};

}  // namespace porefines::dem
