// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

namespace porefines::scale {

struct ScaleOptions {
  std::vector<std::string> cases;  ///< case files, each a sample of its own
  std::vector<std::string>
      weak;  ///< case files of one, two, three ... times the size, for as many ranks
  std::vector<std::string> overrides;  ///< key=value
  std::vector<int> ranks;              ///< empty: powers of two up to the physical cores
  int repeats = 2;                     ///< of each; the fastest counts
  std::string output_dir = "out/scale";
};

/// Runs the cases on different numbers of processes and writes scale.csv, scale.json, scale.png and efficiency.png;
/// says which number to take, and what the model expects of thousands of ranks.
///
/// @return exit code. @throws InputError  a case that does not run
/// Test: cli/scale.
[[nodiscard]] int run_scale(const ScaleOptions& options);

}  // namespace porefines::scale
