// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

namespace porefines::page {

/// A PNG as a data: address, halved until its longer side is at most `longest` pixels; "" when the
/// file is not there or is no PNG. Test: cli/report.
[[nodiscard]] std::string picture_address(const std::string& path, int longest);

}  // namespace porefines::page
