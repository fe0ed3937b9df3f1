// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <string_view>

namespace porefines::io {

/// Writes a whole file so that a reader finds either the old content or the new, never a part.
///
/// The bytes go to `path + ".part"` in the same folder, are synced to disk, and the name is then
/// switched. Symbolic links are replaced, not followed. Call it from one rank.
/// @throws RunError  with the path and the system's reason; the partial file is removed
void replace_file(const std::string& path, std::string_view content);

}  // namespace porefines::io
