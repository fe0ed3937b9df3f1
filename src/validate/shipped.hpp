// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

#include "validate/comparison.hpp"

namespace porefines::validate {

/// What cases/PATH held when the program was built. @throws std::logic_error  it was not asked for
[[nodiscard]] std::string shipped(const std::string& path);

/// Runs cases/FOLDER/CASE_FILE with `files` of the same folder beside it.
/// @param set  words key=value after the case
[[nodiscard]] Job shipped_job(const std::string& name, const std::string& folder,
                              const std::string& case_file, const std::vector<std::string>& files,
                              const std::vector<std::string>& set);

}  // namespace porefines::validate
