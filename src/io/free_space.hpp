// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include "core/types.hpp"

namespace porefines::io {

/// Reserves the space for a file and gives it back: a full disk, a quota or a limit on the file
/// size is found before HDF5, which does not get over a failed write, has begun. One rank.
///
/// @param what  for the message: "12.0 MB of fields"
/// @throws RunError  with the system's reason and the advice
void require_space(const std::string& path, Index bytes, const std::string& what,
                   const std::string& advice);

}  // namespace porefines::io
