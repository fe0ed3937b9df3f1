// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

namespace porefines::validate {

struct ValidateOptions {
  bool quick = false;
  std::vector<std::string> only;  ///< names of comparisons; empty: all
  std::string output_dir = "validate";
  std::string data;      ///< folder of the videos of others; empty: without them
  unsigned at_once = 0;  ///< runs side by side; 0: as many as there are processors
};

/// Runs the comparisons by this program itself and writes OUT/validation.html and OUT/validation.json.
///
/// What a run of the same commit has done in OUT is kept, so that an interrupted validation goes on.
/// Every number stands beside its reference with its tolerance; one that is off, or missing, is red.
/// @return exit_code::done, or stopped_itself when something is red
/// @throws InputError  --only names no comparison, or data is no such folder. One rank.
/// Test: cli/validate.
[[nodiscard]] int run_validation(const ValidateOptions& options);

}  // namespace porefines::validate
