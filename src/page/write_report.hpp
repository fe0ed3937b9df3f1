// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

namespace porefines::page {

/// The page of web/ with data in it: one HTML file that needs nothing else, also no network.
/// @param island  JSON for the page
[[nodiscard]] std::string whole_page(const std::string& title, const std::string& island);

/// Writes DIR/report.html of a run, whole or not at all; returns its path. One rank.
/// @throws InputError  DIR holds no run
[[nodiscard]] std::string write_report(const std::string& folder);

}  // namespace porefines::page
