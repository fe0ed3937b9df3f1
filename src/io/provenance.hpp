// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace porefines::io {

/// Where a result comes from; written into every output file.
struct Provenance {
  std::string version;          ///< of porefines, e.g. "0.1.0"
  std::string commit;           ///< 12 hex digits, "-dirty" when the tree was changed, or "unknown"
  int ranks = 1;                ///< MPI processes
  unsigned long long seed = 0;  ///< of the counter-based random numbers
  std::string date;             ///< UTC, ISO 8601: "2026-11-22T03:00:00Z"
};

/// Fills version and commit from the build and the date from the clock.
///
/// Not collective; ranks may see different seconds, so let one rank's be the one that is written.
[[nodiscard]] Provenance make_provenance(int ranks, unsigned long long seed);

/// Name and value of each entry, in a fixed order, for attributes, text chunks and JSON.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> entries(
    const Provenance& provenance);

/// One line for a person: "porefines 0.1.0 (commit …), 4 ranks, seed 1, 2026-…".
[[nodiscard]] std::string describe(const Provenance& provenance);

}  // namespace porefines::io
