// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

namespace porefines::study {

struct StudyOptions {
  std::string output_dir;                   ///< replaces that of the file
  bool dry_run = false;                     ///< members, time and memory; runs nothing
  std::vector<std::string> overrides = {};  ///< "seeds=2"
};

/// Runs what is not done yet, side by side, and writes tables, statistics and charts of all that is.
///
/// A member that is done stays; one that was interrupted goes on from its checkpoint; one that fails is tried
/// again study.retries times, the reason stays in failure.json. After SIGINT or SIGTERM the members save
/// their state, and the same command goes on. After SIGKILL too: see core/process.
/// @return  exit code: done; stopped_itself when members failed for good; 128 + n after signal n
/// @throws InputError
/// Test: cli/study.
[[nodiscard]] int run_study(const std::string& path, const StudyOptions& options);

}  // namespace porefines::study
