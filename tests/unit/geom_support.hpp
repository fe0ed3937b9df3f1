// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "geom/voxels.hpp"
#include "support/shared_data.hpp"

namespace porefines::geom::support {

using test::shared_file;

/// Scratch folder of one test, empty at the start.
inline std::filesystem::path scratch(const std::string& name) {
  const auto path = std::filesystem::temp_directory_path() / ("porefines_geom_" + name);
  std::filesystem::remove_all(path);
  std::filesystem::create_directories(path);
  return path;
}

/// Binary volume: pore where distance(centre of voxel in pixels) > 0.
inline Voxels rasterise(const Int3& n, const std::function<Real(const Vec3&)>& distance) {
  Voxels voxels = make_voxels(n, 0);
  for (int k = 0; k < n[2]; ++k) {
    for (int j = 0; j < n[1]; ++j) {
      for (int i = 0; i < n[0]; ++i) {
        voxels.at(i, j, k) = distance({i + 0.5, j + 0.5, k + 0.5}) > 0 ? 1 : 0;
      }
    }
  }
  return voxels;
}

/// Volume from rows of text, the top row first as in a picture: '.' is pore, '#' grain.
inline Voxels from_picture(const std::vector<std::string>& rows) {
  const Int3 n{static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), 1};
  Voxels voxels = make_voxels(n, 0);
  for (int j = 0; j < n[1]; ++j) {
    for (int i = 0; i < n[0]; ++i) {
      const std::string& row = rows[static_cast<std::size_t>(n[1] - 1 - j)];
      voxels.at(i, j, 0) = row[static_cast<std::size_t>(i)] == '.' ? 1 : 0;
    }
  }
  return voxels;
}

}  // namespace porefines::geom::support
