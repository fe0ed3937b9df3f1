// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

#include "scale/model.hpp"

namespace porefines::scale {

/// One case on several numbers of ranks.
struct Series {
  std::string name;
  Int3 cells{1, 1, 1};
  std::vector<Measured> runs;
};

/// Runs a case and reads its summary.json; the fastest of `repeats`.
/// @throws InputError  the run fails, with its last lines
[[nodiscard]] Measured measure(const std::string& case_file,
                               const std::vector<std::string>& overrides, int ranks, int repeats,
                               const std::string& folder, Int3& cells);

void write_scaling(const std::string& output, const std::vector<Series>& strong,
                   const std::vector<Measured>& weak, int physical_cores);

}  // namespace porefines::scale
