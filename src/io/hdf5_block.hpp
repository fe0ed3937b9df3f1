// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "io/fields.hpp"
#include "io/hdf5_handle.hpp"

namespace porefines::io {

/// Where a rank's block lies in a dataset [nz][ny][nx] or, with more than one column, [nz][ny][nx][columns].
struct BlockSpaces {
  Hdf5 file;
  Hdf5 memory;
};

/// @param doing  for errors: "writing field velocity"
[[nodiscard]] BlockSpaces block_spaces(const GridBlock& grid, int columns,
                                       const std::string& doing);

/// Rows [first, first + count) of a table with `all` rows.
[[nodiscard]] BlockSpaces row_spaces(hsize_t all, hsize_t first, hsize_t count, int columns,
                                     const std::string& doing);

/// Creates a dataset and writes to it: all ranks together, each its selection. Collective.
void write_together(hid_t file, const std::string& name, hid_t type, hid_t memory_type,
                    const BlockSpaces& spaces, const void* values, const std::string& doing);

}  // namespace porefines::io
