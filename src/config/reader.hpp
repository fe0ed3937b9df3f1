// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/case.hpp"
#include "config/tree.hpp"

namespace porefines::config {

/// Reads and checks a case file: SI, defaults filled, every face of the box decided.
///
/// @param overrides  from the command line, "grid.cell_size=5 um", applied in order; one of several
///                   alternatives (cells for cell_size) replaces the one in the file
/// @throws InputError  `cases/x.toml:12: [grid] cell_sise: unknown key; did you mean cell_size?`
/// Every rank reads the file itself; no communication.
/// Tests: unit/config.
[[nodiscard]] Case load_case(const std::string& path,
                             const std::vector<std::string>& overrides = {});

/// The same from a text. Does not look whether the files named in it exist.
/// @param name  path of the case, for messages and to resolve relative paths
[[nodiscard]] Case parse_case(std::string_view text, const std::string& name,
                              const std::vector<std::string>& overrides = {});

/// What holds between keys. `given` tells where each was said.
/// @throws InputError
void validate(const Case& subject, const Node& given);

}  // namespace porefines::config
