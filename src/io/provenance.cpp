// SPDX-License-Identifier: MPL-2.0
#include "io/provenance.hpp"

#include <chrono>
#include <ctime>

#include <fmt/chrono.h>
#include <fmt/format.h>

// Written by cmake/provenance.cmake at every build.
#if __has_include("commit.hpp")
#include "commit.hpp"
#else
#define PF_COMMIT "unknown"
#endif

namespace porefines::io {

Provenance make_provenance(int ranks, unsigned long long seed) {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return {PF_VERSION, PF_COMMIT, ranks, seed,
          fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now))};
}

std::vector<std::pair<std::string, std::string>> entries(const Provenance& provenance) {
  return {{"version", provenance.version},
          {"commit", provenance.commit},
          {"ranks", fmt::to_string(provenance.ranks)},
          {"seed", fmt::to_string(provenance.seed)},
          {"date", provenance.date}};
}

std::string describe(const Provenance& provenance) {
  return fmt::format("porefines {} (commit {}), {} rank{}, seed {}, {}", provenance.version,
                     provenance.commit, provenance.ranks, provenance.ranks == 1 ? "" : "s",
                     provenance.seed, provenance.date);
}

}  // namespace porefines::io
