// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include "config/case.hpp"

namespace porefines::page {

/// The [[surface]] tables of a case for the player, as a JSON list: planes, cylinders and spheres by their
/// numbers [m], meshes by the corners of their triangles, nine numbers each. A mesh that cannot be read
/// again, or has more than 20,000 triangles, is left out. "" without surfaces. Test: cli/dry_cases.
[[nodiscard]] std::string walls_json(const config::Case& the_case);

}  // namespace porefines::page
