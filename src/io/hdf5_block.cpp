// SPDX-License-Identifier: MPL-2.0
#include "io/hdf5_block.hpp"

#include <array>

namespace porefines::io {
namespace {

BlockSpaces select(int rank, const hsize_t* whole, const hsize_t* start, const hsize_t* count,
                   const std::string& doing) {
  BlockSpaces spaces{{H5Screate_simple(rank, whole, nullptr), H5Sclose, doing},
                     {H5Screate_simple(rank, count, nullptr), H5Sclose, doing}};
  bool empty = false;
  for (int axis = 0; axis < rank; ++axis) {
    empty = empty || count[axis] == 0;
  }
  if (empty) {
    require_hdf5(H5Sselect_none(spaces.file.get()), doing);
    require_hdf5(H5Sselect_none(spaces.memory.get()), doing);
  } else {
    require_hdf5(
        H5Sselect_hyperslab(spaces.file.get(), H5S_SELECT_SET, start, nullptr, count, nullptr),
        doing);
  }
  return spaces;
}

}  // namespace

BlockSpaces block_spaces(const GridBlock& grid, int columns, const std::string& doing) {
  std::array<hsize_t, 4> whole{};
  std::array<hsize_t, 4> start{};
  std::array<hsize_t, 4> count{};
  for (int axis = 0; axis < 3; ++axis) {  // HDF5 counts slowest axis first
    whole[2 - axis] = static_cast<hsize_t>(grid.global_cells[axis]);
    start[2 - axis] = static_cast<hsize_t>(grid.offset[axis]);
    count[2 - axis] = static_cast<hsize_t>(grid.cells[axis]);
  }
  whole[3] = count[3] = static_cast<hsize_t>(columns);
  return select(columns == 1 ? 3 : 4, whole.data(), start.data(), count.data(), doing);
}

BlockSpaces row_spaces(hsize_t all, hsize_t first, hsize_t count, int columns,
                       const std::string& doing) {
  const auto width = static_cast<hsize_t>(columns);
  const std::array<hsize_t, 2> whole{all, width};
  const std::array<hsize_t, 2> start{first, 0};
  const std::array<hsize_t, 2> part{count, width};
  return select(2, whole.data(), start.data(), part.data(), doing);
}

void write_together(hid_t file, const std::string& name, hid_t type, hid_t memory_type,
                    const BlockSpaces& spaces, const void* values, const std::string& doing) {
  Hdf5 creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, doing);
  require_hdf5(H5Pset_fill_time(creation.get(), H5D_FILL_TIME_NEVER), doing);
  Hdf5 dataset(H5Dcreate2(file, name.c_str(), type, spaces.file.get(), H5P_DEFAULT, creation.get(),
                          H5P_DEFAULT),
               H5Dclose, doing);
  if (H5Sget_simple_extent_npoints(spaces.file.get()) > 0) {  // HDF5 refuses to write nothing
    Hdf5 transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose, doing);
    require_hdf5(H5Pset_dxpl_mpio(transfer.get(), H5FD_MPIO_COLLECTIVE), doing);
    require_hdf5(H5Dwrite(dataset.get(), memory_type, spaces.memory.get(), spaces.file.get(),
                          transfer.get(), values),
                 doing);
  }
  dataset.finish(doing);
}

}  // namespace porefines::io
