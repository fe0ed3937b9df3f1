// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include "io/read_table.hpp"

namespace porefines::page {

/// Table as JSON: {"rows": as in the file, "columns": {"name": [numbers]}}, thinned to `most` rows evenly,
/// the last one kept.
[[nodiscard]] std::string columns_json(const io::TextTable& table, std::size_t most);

}  // namespace porefines::page
