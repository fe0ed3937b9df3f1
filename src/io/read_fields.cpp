// SPDX-License-Identifier: MPL-2.0
#include "io/read_fields.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

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

}  // namespace

FieldVolume read_last_field(const std::string& folder, const std::string& name) {
  silence_hdf5();
  const std::string path = last_step(folder);
  const Hdf5 file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "opening " + path);
  FieldVolume out;
  std::array<Index, 3> cells{};
  std::array<Real, 3> origin{};
  std::array<Real, 3> spacing{};
  read_attribute(file.get(), "cells", H5T_NATIVE_INT64, cells.data());
  read_attribute(file.get(), "origin_m", H5T_NATIVE_DOUBLE, origin.data());
  read_attribute(file.get(), "spacing_m", H5T_NATIVE_DOUBLE, spacing.data());
  read_attribute(file.get(), "time_s", H5T_NATIVE_DOUBLE, &out.time);
  std::transform(cells.begin(), cells.end(), out.cells.begin(),
                 [](Index n) { return static_cast<int>(n); });
  out.origin = {origin[0], origin[1], origin[2]};
  out.spacing = {spacing[0], spacing[1], spacing[2]};
  if (H5Lexists(file.get(), name.c_str(), H5P_DEFAULT) <= 0) {
    throw InputError(path + ": has no field " + name);
  }
  const Hdf5 data(H5Dopen2(file.get(), name.c_str(), H5P_DEFAULT), H5Dclose, "opening " + name);
  const Hdf5 space(H5Dget_space(data.get()), H5Sclose, "looking at " + name);
  out.values.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get())));
  out.components = static_cast<int>(static_cast<Index>(out.values.size()) / product(out.cells));
  require_hdf5(
      H5Dread(data.get(), H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, out.values.data()),
      "reading " + name);
  return out;
}

}  // namespace porefines::io
