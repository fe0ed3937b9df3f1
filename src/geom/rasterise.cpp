// SPDX-License-Identifier: MPL-2.0
#include "geom/rasterise.hpp"

#include <algorithm>
#include <cmath>

namespace porefines::geom {

Voxels rasterise(const Sample& sample, Real pixel) {
  const Vec3 size = sample.box.size;
  const bool flat = sample.spec.kind == Kind::cylinders;
  Int3 n{};
  Vec3 edge;
  for (int axis = 0; axis < 3; ++axis) {
    n[axis] =
        flat && axis == 2 ? 1 : std::max(1, static_cast<int>(std::lround(size[axis] / pixel)));
    edge[axis] = size[axis] / n[axis];
  }
  const Solid solid = make_solid(sample, {}, size, pixel);
  Voxels voxels = make_voxels(n, 0);
  std::size_t at = 0;
  for (int k = 0; k < n[2]; ++k) {
    for (int j = 0; j < n[1]; ++j) {
      for (int i = 0; i < n[0]; ++i, ++at) {
        const Vec3 centre{(i + 0.5) * edge.x, (j + 0.5) * edge.y, (k + 0.5) * edge.z};
        voxels.pore[at] = signed_distance(solid, centre) > 0 ? 1 : 0;
      }
    }
  }
  return voxels;
}

Real pixel_for(const Sample& sample, Real voxels) {
  const Vec3 size = sample.box.size;
  return sample.spec.kind == Kind::cylinders ? std::sqrt(size.x * size.y / voxels)
                                             : std::cbrt(size.x * size.y * size.z / voxels);
}

}  // namespace porefines::geom
