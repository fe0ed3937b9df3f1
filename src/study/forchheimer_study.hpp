// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

namespace porefines::study {

/// Is this the folder of a study?
[[nodiscard]] bool is_study(const std::string& folder);

/// k, beta and the end of Darcy's law from the members of a study that differ in what drives them; writes
/// forchheimer.json, forchheimer.csv, forchheimer.png and says the result. See analysis/forchheimer.hpp.
/// @throws InputError  members that are creeping flows or of different fluids, too few of them
/// Test: cli/forchheimer.
void fit_sweep(const std::string& folder, const std::string& output);

}  // namespace porefines::study
