// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "report/picture.hpp"

namespace porefines::report {

/// A sphere to draw; lengths in m.
struct Disc {
  Vec3 centre;
  Real radius = 0;
  Real value = 0;  ///< what its colour shows
};

/// Where the spheres are.
struct Scene {
  Vec3 low;
  Vec3 high;
  std::array<int, 2> axes{0, 2};           ///< which axis runs to the right, which one up
  std::function<bool(const Vec3&)> solid;  ///< is there a wall or grain? asked on the middle plane
};

/// All spheres seen along the third axis, the nearer over the farther (the higher where one looks
/// down), coloured by value over grains and walls; title, colour bar, scale bar.
[[nodiscard]] Picture draw_particles(std::vector<Disc> discs, const Scene& scene,
                                     const PictureStyle& style);

}  // namespace porefines::report
