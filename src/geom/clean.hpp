// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <string>

#include "geom/components.hpp"
#include "geom/voxels.hpp"

namespace porefines::geom {

/// Turn every component of `phase` with fewer than `fewest` voxels into the other phase.
/// @return voxels changed
Index remove_small(Voxels& voxels, Phase phase, Index fewest, const std::array<bool, 3>& periodic);

/// Fill the pores that carry no flow along `axis`: that do not connect its two faces or, when it
/// is periodic, do not close on themselves around the period.
/// @return voxels filled
/// Error: InputError when no pore percolates, with advice.
Index keep_percolating(Voxels& voxels, const std::array<bool, 3>& periodic, int axis,
                       const std::string& name);

/// Open grain walls of at most `gap` voxels, measured along x, y or z, that part two pores which
/// are not connected otherwise (throats lost in imaging).
/// @return voxels opened
Index reconnect(Voxels& voxels, int gap, const std::array<bool, 3>& periodic);

}  // namespace porefines::geom
