// SPDX-License-Identifier: MPL-2.0
#include "io/read_fields.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include "core/error.hpp"
#include "io/fields_file.hpp"
#include "io/hdf5_handle.hpp"

namespace porefines::io {
namespace {

std::string last_step(const std::string& folder) {
  int step = 0;
  while (std::filesystem::exists(folder + "/" + step_file(step))) {
    ++step;
  }
  if (step == 0) {
    throw InputError(folder +
                     ": holds no fields\nthe case must ask for [[output]] kind = \"fields\"");
  }
  return folder + "/" + step_file(step - 1);
}

/// Where the cells lie, and how many the file has; no values yet.
FieldVolume read_frame(hid_t file) {
  FieldVolume out;
  std::array<Index, 3> cells{};
  std::array<Real, 3> origin{};
  std::array<Real, 3> spacing{};
  read_attribute(file, "cells", H5T_NATIVE_INT64, cells.data());
  read_attribute(file, "origin_m", H5T_NATIVE_DOUBLE, origin.data());
  read_attribute(file, "spacing_m", H5T_NATIVE_DOUBLE, spacing.data());
  read_attribute(file, "time_s", H5T_NATIVE_DOUBLE, &out.time);
  std::transform(cells.begin(), cells.end(), out.cells.begin(),
                 [](Index n) { return static_cast<int>(n); });
  out.origin = {origin[0], origin[1], origin[2]};
  out.spacing = {spacing[0], spacing[1], spacing[2]};
  return out;
}

/// Reads the whole field, or the plane in the middle of `axis`.
FieldVolume read_last(const std::string& folder, const std::string& name, std::optional<int> axis) {
  silence_hdf5();
  const std::string path = last_step(folder);
  const Hdf5 file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "opening " + path);
  FieldVolume out = read_frame(file.get());
  if (H5Lexists(file.get(), name.c_str(), H5P_DEFAULT) <= 0) {
    throw InputError(path + ": has no field " + name);
  }
  const Hdf5 data(H5Dopen2(file.get(), name.c_str(), H5P_DEFAULT), H5Dclose, "opening " + name);
  const Hdf5 space(H5Dget_space(data.get()), H5Sclose, "looking at " + name);
  const Index numbers = H5Sget_simple_extent_npoints(space.get());
  out.components = static_cast<int>(numbers / product(out.cells));
  std::array<hsize_t, 4> first{};
  std::array<hsize_t, 4> count{1, 1, 1, static_cast<hsize_t>(out.components)};
  if (axis) {
    const int middle = out.cells[*axis] / 2;
    first[2 - *axis] = static_cast<hsize_t>(middle);
    out.origin[*axis] += middle * out.spacing[*axis];
    out.cells[*axis] = 1;
  }
  for (int a = 0; a < 3; ++a) {
    count[2 - a] = static_cast<hsize_t>(out.cells[a]);
  }
  out.values.resize(static_cast<std::size_t>(product(out.cells)) * out.components);
  require_hdf5(H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, first.data(), nullptr, count.data(),
                                   nullptr),
               "choosing a part of " + name);
  const hsize_t total = out.values.size();
  const Hdf5 memory(H5Screate_simple(1, &total, nullptr), H5Sclose, "reading " + name);
  require_hdf5(H5Dread(data.get(), H5T_NATIVE_FLOAT, memory.get(), space.get(), H5P_DEFAULT,
                       out.values.data()),
               "reading " + name);
  return out;
}

}  // namespace

bool has_field(const std::string& folder, const std::string& name) {
  silence_hdf5();
  const std::string path = last_step(folder);
  const Hdf5 file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "opening " + path);
  return H5Lexists(file.get(), name.c_str(), H5P_DEFAULT) > 0;
}

FieldVolume read_last_field(const std::string& folder, const std::string& name) {
  return read_last(folder, name, std::nullopt);
}

FieldVolume read_last_plane(const std::string& folder, const std::string& name, int axis) {
  return read_last(folder, name, axis);
}

}  // namespace porefines::io
