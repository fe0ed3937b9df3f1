// SPDX-License-Identifier: MPL-2.0
#include "io/hdf5_handle.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.hpp"

namespace porefines::io {
namespace {

/// The innermost entry says why, the outermost what was called.
std::string error_stack_in_short() {
  struct Ends {
    std::string inner;
    std::string outer;
  } ends;
  const auto visit = [](unsigned depth, const H5E_error2_t* error, void* data) -> herr_t {
    auto& seen = *static_cast<Ends*>(data);
    (depth == 0 ? seen.inner : seen.outer) = error->desc != nullptr ? error->desc : "";
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, visit, &ends);
  H5Eclear2(H5E_DEFAULT);
  if (ends.inner.empty()) {
    return "no reason given";
  }
  return ends.outer.empty() ? ends.inner : fmt::format("{} ({})", ends.outer, ends.inner);
}

void write_simple(hid_t owner, const std::string& name, hid_t type, hid_t space, const void* data) {
  Hdf5 attribute(H5Acreate2(owner, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                 "creating attribute " + name);
  require_hdf5(H5Awrite(attribute.get(), type, data), "writing attribute " + name);
}

void write_numbers(hid_t owner, const std::string& name, hid_t type, std::size_t count,
                   const void* data) {
  const hsize_t length = count;
  Hdf5 space(count == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &length, nullptr), H5Sclose,
             "describing attribute " + name);
  write_simple(owner, name, type, space.get(), data);
}

}  // namespace

void silence_hdf5() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

void require_hdf5(herr_t status, std::string_view doing) {
  if (status < 0) {
    throw RunError(fmt::format("{}: {}", doing, error_stack_in_short()));
  }
}

void write_attribute(hid_t owner, const std::string& name, const std::string& text) {
  Hdf5 type(H5Tcopy(H5T_C_S1), H5Tclose, "describing attribute " + name);
  require_hdf5(H5Tset_size(type.get(), std::max<std::size_t>(1, text.size())), name);
  require_hdf5(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), name);
  Hdf5 space(H5Screate(H5S_SCALAR), H5Sclose, "describing attribute " + name);
  write_simple(owner, name, type.get(), space.get(), text.c_str());
}

void write_attribute(hid_t owner, const std::string& name, std::span<const Real> values) {
  write_numbers(owner, name, H5T_NATIVE_DOUBLE, values.size(), values.data());
}

void write_attribute(hid_t owner, const std::string& name, std::span<const Index> values) {
  write_numbers(owner, name, H5T_NATIVE_INT64, values.size(), values.data());
}

void write_attributes(hid_t owner, const Provenance& provenance) {
  for (const auto& [name, value] : entries(provenance)) {
    write_attribute(owner, name, value);
  }
}

void read_attribute(hid_t owner, const std::string& name, hid_t type, void* value) {
  const std::string doing = "reading attribute " + name;
  Hdf5 attribute(H5Aopen(owner, name.c_str(), H5P_DEFAULT), H5Aclose, doing);
  require_hdf5(H5Aread(attribute.get(), type, value), doing);
}

Hdf5 parallel_access(MPI_Comm comm) {
  const std::string doing = "preparing parallel access";
  Hdf5 access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, doing);
  require_hdf5(H5Pset_fapl_mpio(access.get(), comm, MPI_INFO_NULL), doing);
  require_hdf5(H5Pset_coll_metadata_write(access.get(), true), doing);
  return access;
}

}  // namespace porefines::io
