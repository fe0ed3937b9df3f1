// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

#include "core/types.hpp"
#include "io/provenance.hpp"

namespace porefines::io {

/// One time step in an HDF5 file of its own: datasets `/<name>`, float32, cell-centred,
/// of shape [nz][ny][nx] (scalars) or [nz][ny][nx][3] (vectors).
struct FieldStep {
  Real time = 0;     ///< [s]
  std::string file;  ///< relative to the folder of the XDMF file
  std::vector<std::string> scalars;
  std::vector<std::string> vectors;
};

/// The XDMF 2 text that lists all steps as a temporal collection of one uniform grid.
///
/// XDMF counts slowest axis first: dimensions, origin and spacing are written z y x.
/// @param cells    [-]  nx, ny, nz
/// @param origin   [m]  low corner of cell (0, 0, 0)
/// @param spacing  [m]  edges of a cell
[[nodiscard]] std::string xdmf_text(const Int3& cells, const Vec3& origin, const Vec3& spacing,
                                    const std::vector<FieldStep>& steps,
                                    const Provenance& provenance);

}  // namespace porefines::io
