// SPDX-License-Identifier: MPL-2.0
#include "io/fields_file.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "io/hdf5_handle.hpp"

namespace porefines::io {
namespace {

constexpr const char* cells_name = "cells";
constexpr const char* time_name = "time_s";

/// Access through MPI-IO. Changed metadata stays in memory until the file closes, when the field
/// values are on disk already: a run killed while it writes a large field harms no earlier step.
Hdf5 parallel_access(MPI_Comm comm) {
  Hdf5 access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "preparing parallel access");
  require_hdf5(H5Pset_fapl_mpio(access.get(), comm, MPI_INFO_NULL), "preparing parallel access");
  require_hdf5(H5Pset_coll_metadata_write(access.get(), true), "preparing parallel access");
  require_hdf5(H5Pset_all_coll_metadata_ops(access.get(), true), "preparing parallel access");
  H5AC_cache_config_t cache{};
  cache.version = H5AC__CURR_CACHE_CONFIG_VERSION;
  require_hdf5(H5Pget_mdc_config(access.get(), &cache), "preparing parallel access");
  cache.evictions_enabled = false;
  cache.incr_mode = H5C_incr__off;
  cache.flash_incr_mode = H5C_flash_incr__off;
  cache.decr_mode = H5C_decr__off;
  require_hdf5(H5Pset_mdc_config(access.get(), &cache), "preparing parallel access");
  return access;
}

Hdf5 open_file(const std::string& path, unsigned mode, hid_t access) {
  return {H5Fopen(path.c_str(), mode, access), H5Fclose, "opening " + path};
}

bool exists(hid_t where, const std::string& name) {
  return H5Lexists(where, name.c_str(), H5P_DEFAULT) > 0;
}

/// One field: all ranks write their hyperslabs together. `components` is 1 or 3.
void write_field(hid_t group, const GridBlock& grid, const std::string& name,
                 std::span<const float> values, int components) {
  const std::string doing = "writing field " + name;
  const int rank = components == 1 ? 3 : 4;
  std::array<hsize_t, 4> whole{};
  std::array<hsize_t, 4> start{};
  std::array<hsize_t, 4> count{};
  for (int axis = 0; axis < 3; ++axis) {  // HDF5 counts slowest axis first
    whole[2 - axis] = static_cast<hsize_t>(grid.global_cells[axis]);
    start[2 - axis] = static_cast<hsize_t>(grid.offset[axis]);
    count[2 - axis] = static_cast<hsize_t>(grid.cells[axis]);
  }
  whole[3] = count[3] = static_cast<hsize_t>(components);

  Hdf5 file_space(H5Screate_simple(rank, whole.data(), nullptr), H5Sclose, doing);
  Hdf5 memory_space(H5Screate_simple(rank, count.data(), nullptr), H5Sclose, doing);
  if (values.empty()) {
    require_hdf5(H5Sselect_none(file_space.get()), doing);
    require_hdf5(H5Sselect_none(memory_space.get()), doing);
  } else {
    require_hdf5(H5Sselect_hyperslab(file_space.get(), H5S_SELECT_SET, start.data(), nullptr,
                                     count.data(), nullptr),
                 doing);
  }
  Hdf5 creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, doing);
  require_hdf5(H5Pset_fill_time(creation.get(), H5D_FILL_TIME_NEVER), doing);
  Hdf5 dataset(H5Dcreate2(group, name.c_str(), H5T_IEEE_F32LE, file_space.get(), H5P_DEFAULT,
                          creation.get(), H5P_DEFAULT),
               H5Dclose, doing);
  Hdf5 transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose, doing);
  require_hdf5(H5Pset_dxpl_mpio(transfer.get(), H5FD_MPIO_COLLECTIVE), doing);
  require_hdf5(H5Dwrite(dataset.get(), H5T_NATIVE_FLOAT, memory_space.get(), file_space.get(),
                        transfer.get(), values.data()),
               doing);
  dataset.finish(doing);
}

void describe_grid(hid_t file, const GridBlock& grid) {
  const auto& n = grid.global_cells;
  const std::array<Index, 3> cells{n[0], n[1], n[2]};
  const std::array<Real, 3> origin{grid.origin.x, grid.origin.y, grid.origin.z};
  const std::array<Real, 3> spacing{grid.spacing.x, grid.spacing.y, grid.spacing.z};
  write_attribute(file, cells_name, cells);
  write_attribute(file, "origin_m", origin);
  write_attribute(file, "spacing_m", spacing);
}

void read_attribute(hid_t owner, const std::string& name, hid_t type, void* value) {
  const std::string doing = "reading attribute " + name;
  Hdf5 attribute(H5Aopen(owner, name.c_str(), H5P_DEFAULT), H5Aclose, doing);
  require_hdf5(H5Aread(attribute.get(), type, value), doing);
}

herr_t note_field(hid_t group, const char* name, const H5L_info_t*, void* step) {
  const hid_t dataset = H5Dopen2(group, name, H5P_DEFAULT);
  const hid_t space = dataset < 0 ? -1 : H5Dget_space(dataset);
  const int rank = space < 0 ? -1 : H5Sget_simple_extent_ndims(space);
  H5Sclose(space);
  H5Dclose(dataset);
  auto& fields = *static_cast<FieldStep*>(step);
  (rank == 4 ? fields.vectors : fields.scalars).emplace_back(name);
  return rank < 0 ? -1 : 0;
}

FieldStep read_step(hid_t file, const std::string& name) {
  FieldStep step;
  step.group = name;
  Hdf5 group(H5Gopen2(file, name.c_str(), H5P_DEFAULT), H5Gclose, "opening step " + name);
  read_attribute(group.get(), time_name, H5T_NATIVE_DOUBLE, &step.time);
  require_hdf5(H5Literate(group.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, note_field, &step),
               "listing step " + name);
  return step;
}

void require_same_grid(hid_t file, const std::string& path, const Int3& cells) {
  std::array<Index, 3> found{};
  read_attribute(file, cells_name, H5T_NATIVE_INT64, found.data());
  if (!std::equal(found.begin(), found.end(), cells.begin())) {
    throw RunError(fmt::format("{}: has {} cells, this run {}", path, fmt::join(found, " x "),
                               fmt::join(cells, " x ")));
  }
}

}  // namespace

std::string step_group(int step) {
  return fmt::format("step_{:06}", step);
}

void create_fields_file(const std::string& path, MPI_Comm comm, const GridBlock& grid,
                        const Provenance& provenance) {
  const Hdf5 access = parallel_access(comm);
  Hdf5 file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()), H5Fclose,
            "creating " + path);
  for (const auto& [name, value] : entries(provenance)) {
    write_attribute(file.get(), name, value);
  }
  describe_grid(file.get(), grid);
  file.finish("closing " + path);
}

void append_step(const std::string& path, MPI_Comm comm, const GridBlock& grid,
                 const std::string& group_name, Real time, std::span<const ScalarField> scalars,
                 std::span<const VectorField> vectors) {
  const Hdf5 access = parallel_access(comm);
  Hdf5 file = open_file(path, H5F_ACC_RDWR, access.get());
  if (exists(file.get(), group_name)) {
    require_hdf5(H5Ldelete(file.get(), group_name.c_str(), H5P_DEFAULT), "replacing " + group_name);
  }
  {
    Hdf5 group(H5Gcreate2(file.get(), group_name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
               H5Gclose, "creating group " + group_name);
    write_attribute(group.get(), time_name, std::span<const Real>(&time, 1));
    for (const ScalarField& field : scalars) {
      write_field(group.get(), grid, field.name, field.values, 1);
    }
    for (const VectorField& field : vectors) {
      write_field(group.get(), grid, field.name, field.values, 3);
    }
  }
  file.finish("closing " + path);
}

std::vector<FieldStep> keep_steps_until(const std::string& path, const Int3& cells, Real time) {
  Hdf5 file = open_file(path, H5F_ACC_RDWR, H5P_DEFAULT);
  require_same_grid(file.get(), path, cells);
  std::vector<FieldStep> steps;
  int step = 0;
  for (; exists(file.get(), step_group(step)); ++step) {
    FieldStep stored = read_step(file.get(), step_group(step));
    if (!(stored.time <= time)) {
      break;
    }
    steps.push_back(std::move(stored));
  }
  for (; exists(file.get(), step_group(step)); ++step) {
    require_hdf5(H5Ldelete(file.get(), step_group(step).c_str(), H5P_DEFAULT), "dropping a step");
  }
  file.finish("closing " + path);
  return steps;
}

}  // namespace porefines::io
