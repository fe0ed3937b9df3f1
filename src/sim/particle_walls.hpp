// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <vector>

#include "config/case.hpp"
#include "dem/surface.hpp"
#include "geom/build.hpp"

namespace porefines::sim {

/// What particles of a case bump into.
struct Walls {
  dem::Surfaces surfaces;
  std::vector<bool> smooth;  ///< for each: no friction
};

/// Faces of the box, [[surface]] and the grains of the geometry, whole on every rank.
///
/// Grains of an image are the smooth surface of its signed distance; the flow sees the same.
/// @param low, high  [m] corners of the particles' box: the sample's, or more where fluid is beyond
/// @throws InputError  an STL file that cannot be read
[[nodiscard]] Walls make_walls(const config::Case& the_case, const geom::Sample& sample,
                               const Vec3& low, const Vec3& high);

/// [m] radius of the largest particle that the case may hold.
[[nodiscard]] Real largest_radius(const config::Case& the_case);

}  // namespace porefines::sim
