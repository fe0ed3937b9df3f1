// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <optional>
#include <vector>

#include "geom/basins.hpp"

namespace porefines::geom {

/// Measures single throats on a distance field.
///
/// - centre: where the gap is narrowest, the middle of that stretch in a channel;
/// - width: the shortest chord through it, from wall to wall (48 directions in the plane,
///   160 on the half sphere, the best then turned in halving steps down to 1 degree);
/// - normal: in 2D along the middle of the gap, a width to both sides; in 3D, of the planes that hold the chord, the
///   one in which the section is smallest, A = 1/2 sum r(theta)^2 dtheta over rays, each cut at 8
///   widths;
/// - behind, ahead: marching along the normal, kept in the middle of the gap, until the gap is
///   wider than 5/4 width; at most 6 widths.
/// Tests: unit/geom_throats (slit, tube, elliptic neck, discs: widths, areas and lengths).
class ThroatShape {
 public:
  ThroatShape(const VoxelSolid& solid, const Basins& pores, const std::array<bool, 3>& periodic,
              const ThroatFrame& frame);

  /// Nothing where no wall is found on both sides.
  /// @param x          [m] inside the throat
  /// @param low, high  the basins that meet there
  [[nodiscard]] std::optional<Throat> measure(const Vec3& x, std::int32_t low,
                                              std::int32_t high) const;

 private:
  [[nodiscard]] Vec3 away_from_walls(Vec3 x) const;
  [[nodiscard]] std::optional<Throat> shortest_chord(const Vec3& x) const;
  void find_normal(Throat& throat) const;
  [[nodiscard]] Real section(const Throat& throat, const Vec3& normal, int rays) const;
  void follow_middle(Throat& throat) const;
  void orient(Throat& throat, std::int32_t low, std::int32_t high) const;
  /// The gap at one place along the normal; the last one may be wider than a throat.
  struct Gap {
    Vec3 middle;
    Real width;
    Real gone;  ///< [m] from the centre
  };
  [[nodiscard]] std::vector<Gap> gaps(const Throat& throat, Real sign) const;
  [[nodiscard]] Vec3 middle_of_narrowest(const Throat& throat) const;
  [[nodiscard]] Real extent(const Throat& throat, Real sign) const;
  [[nodiscard]] std::int32_t basin_at(const Vec3& x) const;
  [[nodiscard]] Vec3 inside(Vec3 x) const;

  [[nodiscard]] Real way_to_face(const Vec3& x, const Vec3& e) const;
  [[nodiscard]] Real way_to_wall(const Vec3& x, const Vec3& e, Real most) const;

  const VoxelSolid& solid_;
  const Basins& pores_;
  std::array<bool, 3> periodic_;
  ThroatFrame frame_;
  bool flat_;
  std::vector<Vec3> directions_;
};

}  // namespace porefines::geom
