// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

#include "geom/basins.hpp"
#include "geom/voxel_solid.hpp"
#include "report/picture.hpp"

namespace porefines::report {

/// A sample as it was understood.
struct GeometryView {
  geom::VoxelView found;                    ///< binary image before cleaning
  geom::VoxelView kept;                     ///< and after
  const geom::VoxelSolid* solid = nullptr;  ///< smooth surface of `kept`, whole image
  const std::vector<geom::Throat>* throats = nullptr;
  BoxFace flow_to = BoxFace::x_high;
};

/// Pore, grains with their smooth outline, what cleaning changed, and throats as bars across their
/// narrowest place coloured by width; legend, scale bar, flow arrow.
///
/// A 3D sample is cut in the middle along z (along y when the flow runs along z); throats within
/// two voxels of the cut are drawn.
/// @param longer_side  [pixels] of the plot area, about
[[nodiscard]] Picture draw_geometry(const GeometryView& view, const std::string& title,
                                    int longer_side = 1400);

}  // namespace porefines::report
