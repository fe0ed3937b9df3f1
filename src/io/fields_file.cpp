// SPDX-License-Identifier: MPL-2.0
#include "io/fields_file.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "core/error.hpp"
#include "io/hdf5_block.hpp"
#include "io/hdf5_handle.hpp"

namespace porefines::io {
namespace {

constexpr const char* cells_name = "cells";
constexpr const char* time_name = "time_s";

/// One field: all ranks write their hyperslabs together. `components` is 1 or 3.
void write_field(hid_t file, const GridBlock& grid, const std::string& name,
                 std::span<const float> values, int components) {
  const std::string doing = "writing field " + name;
  write_together(file, name, H5T_IEEE_F32LE, H5T_NATIVE_FLOAT,
                 block_spaces(grid, components, doing), values.data(), doing);
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

void require_same_grid(hid_t file, const std::string& path, const Int3& cells) {
  std::array<Index, 3> found{};
  read_attribute(file, cells_name, H5T_NATIVE_INT64, found.data());
  if (!std::equal(found.begin(), found.end(), cells.begin())) {
    throw RunError(fmt::format("{}: has {} cells, this run {}", path, fmt::join(found, " x "),
                               fmt::join(cells, " x ")));
  }
}

}  // namespace

std::string step_file(int step) {
  return fmt::format("fields_{:06}.h5", step);
}

void write_step_file(const std::string& path, MPI_Comm comm, const GridBlock& grid, Real time,
                     std::span<const ScalarField> scalars, std::span<const VectorField> vectors,
                     const Provenance& provenance) {
  const Hdf5 access = parallel_access(comm);
  Hdf5 file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()), H5Fclose,
            "creating " + path);
  write_attributes(file.get(), provenance);
  describe_grid(file.get(), grid);
  write_attribute(file.get(), time_name, std::span<const Real>(&time, 1));
  for (const ScalarField& field : scalars) {
    write_field(file.get(), grid, field.name, field.values, 1);
  }
  for (const VectorField& field : vectors) {
    write_field(file.get(), grid, field.name, field.values, 3);
  }
  file.finish("closing " + path);
}

FieldStep read_step_file(const std::string& folder, const std::string& name, const Int3& cells) {
  const std::string path = folder + "/" + name;
  const Hdf5 file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "opening " + path);
  require_same_grid(file.get(), path, cells);
  FieldStep step;
  step.file = name;
  read_attribute(file.get(), time_name, H5T_NATIVE_DOUBLE, &step.time);
  require_hdf5(H5Literate(file.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, note_field, &step),
               "listing the fields of " + path);
  return step;
}

void write_index(const std::string& folder, const std::vector<FieldStep>& steps,
                 const Provenance& provenance) {
  const std::string path = folder + "/fields.h5";
  const std::string part = path + ".part";
  Hdf5 file(H5Fcreate(part.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose,
            "creating " + part);
  write_attributes(file.get(), provenance);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    require_hdf5(H5Lcreate_external(steps[i].file.c_str(), "/", file.get(),
                                    fmt::format("step_{:06}", i).c_str(), H5P_DEFAULT, H5P_DEFAULT),
                 "writing " + part);
  }
  file.finish("closing " + part);
  std::filesystem::rename(part, path);
}

}  // namespace porefines::io
