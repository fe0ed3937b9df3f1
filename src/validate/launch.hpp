// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

#include "validate/comparison.hpp"

namespace porefines::validate {

/// A job in its folder, and how it went.
struct Launch {
  const Job* job = nullptr;
  std::string folder;
  bool kept = false;  ///< done before by the same commit
  int exit_code = 0;
};

/// Did this commit finish the job already? Never for a tree that was changed.
[[nodiscard]] bool is_done(const std::string& folder, const std::string& commit);

/// Runs the jobs, `at_once` of them side by side; done ones are kept. `tell` hears of each when it ends.
void run_jobs(std::vector<Launch>& launches, unsigned at_once, const std::string& commit,
              void (*tell)(const Launch&));

}  // namespace porefines::validate
