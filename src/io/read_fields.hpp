// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

#include "core/types.hpp"

namespace porefines::io {

/// Fields of one time step in memory; SI, cell-centred, x fastest, then y, z.
struct FieldVolume {
  Int3 cells{0, 0, 0};
  Vec3 origin;   ///< [m] low corner
  Vec3 spacing;  ///< [m]
  Real time = 0;
  std::vector<float> values;  ///< `components` side by side per cell
  int components = 1;
};

/// Reads a field of the last step that FieldWriter left in a folder. One rank.
/// @throws InputError  no steps there, or no field of this name
/// Test: vision/flow_field.
[[nodiscard]] FieldVolume read_last_field(const std::string& folder, const std::string& name);

/// Does the last step hold a field of this name? One rank.
/// @throws InputError  no steps there
[[nodiscard]] bool has_field(const std::string& folder, const std::string& name);

/// The plane of cells nearest to the middle of such a field, normal to `axis`; reads that plane alone.
/// In the result cells[axis] is 1 and origin lies at the plane's low corner. One rank.
/// @throws InputError  as read_last_field
/// Test: cli/report (page_shows_the_run).
[[nodiscard]] FieldVolume read_last_plane(const std::string& folder, const std::string& name,
                                          int axis);

}  // namespace porefines::io
