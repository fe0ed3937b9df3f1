// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>

#include "geom/voxels.hpp"

namespace porefines::geom {

/// An etched-chip picture to make: irregular grains like a cut through sandstone.
struct MicromodelSpec {
  Int3 pixels{2000, 1500, 1};
  Real porosity = 0.45;
  Real grain = 60;        ///< [pixels] mean equivalent diameter
  Real spread = 0.35;     ///< standard deviation / mean of the grain sizes
  Real throat = 6;        ///< [pixels] least throat width
  Real roughness = 0.5;   ///< 0: smooth polygons, 1: strongly convex-concave outlines
  Real cemented = 0.05;   ///< share of neighbouring grains grown together
  bool periodic = false;  ///< along x and y
  std::uint64_t seed = 1;
};

/// Draw grains at the porosity asked for (within 0.001), all throats at least `throat` wide,
/// percolating along x and y.
///
/// Each pixel, displaced by smooth noise, asks for its distance to the border of its cell in a
/// power diagram of random centres with lognormal sizes,
///
///     f = min over cells b (pow_b - pow_a) / (2 |c_b - c_a|) - w_ab,   pow = |x - c|^2 - r^2,
///
/// where w_ab spreads the widths of the channels and cemented cells do not part. Blurred to round
/// the corners, f > t is grain; t follows from the porosity. Then throats are opened (see
/// open_throats), crevices narrower than a throat, islands and dead pores are removed, and t is
/// corrected for what that changed.
/// The same picture for the same numbers on every platform that rounds alike.
/// Cost: about 1 us per pixel. Test: unit/geom_generate.
/// Errors: InputError for sizes that cannot work.
[[nodiscard]] Voxels make_micromodel(const MicromodelSpec& spec);

}  // namespace porefines::geom
