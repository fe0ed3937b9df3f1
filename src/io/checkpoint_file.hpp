// SPDX-License-Identifier: MPL-2.0
// Names and types inside checkpoint.h5, shared by its writer and reader.
#pragma once

#include <string>

#include <fmt/format.h>
#include <hdf5.h>

#include "io/checkpoint.hpp"

namespace porefines::io {

inline constexpr const char* writers_attribute = "ranks_that_wrote";
inline constexpr const char* starts_attribute = "starts";

/// checkpoint.h5 is the newest, checkpoint_1.h5 the one before.
[[nodiscard]] inline std::string checkpoint_path(const std::string& folder, int age) {
  return folder + (age == 0 ? "/checkpoint.h5" : fmt::format("/checkpoint_{}.h5", age));
}

[[nodiscard]] inline hid_t native_type(Stored type) {
  switch (type) {
    case Stored::f64:
      return H5T_NATIVE_DOUBLE;
    case Stored::f32:
      return H5T_NATIVE_FLOAT;
    case Stored::i64:
      return H5T_NATIVE_INT64;
    case Stored::u64:
      return H5T_NATIVE_UINT64;
    case Stored::u32:
      return H5T_NATIVE_UINT32;
    case Stored::u16:
      return H5T_NATIVE_UINT16;
    case Stored::u8:
      break;
  }
  return H5T_NATIVE_UINT8;
}

}  // namespace porefines::io
