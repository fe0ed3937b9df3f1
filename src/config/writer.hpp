// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include "config/case.hpp"

namespace porefines::config {

/// The case as TOML: SI, defaults filled, absolute paths. Reading it gives the same Case, bit for bit
/// (tests: unit/config_round_trip).
[[nodiscard]] std::string effective_case(const Case& subject);

/// docs/case-reference.md: every key with its type, default and meaning.
[[nodiscard]] std::string reference_page();

}  // namespace porefines::config
