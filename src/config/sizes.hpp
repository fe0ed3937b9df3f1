// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include "config/case_particles.hpp"
#include "config/tree.hpp"

namespace porefines::config {

/// Reads `diameter`: a length, or a table with a distribution. Where a normal or lognormal one is
/// cut is filled in: at three standard deviations.
/// @throws InputError
/// Tests: unit/config_particles.
[[nodiscard]] Sizes read_sizes(const Node& node);

/// The TOML value; "" when there is no diameter.
[[nodiscard]] std::string write_sizes(const Sizes& sizes);

}  // namespace porefines::config
