// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

namespace porefines {

/// A whole file as it is; empty when it cannot be read.
[[nodiscard]] std::string read_text(const std::string& path);

}  // namespace porefines
