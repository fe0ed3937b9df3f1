// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <optional>

#include "config/case.hpp"
#include "core/log.hpp"
#include "par/communicator.hpp"
#include "sim/run.hpp"

namespace porefines::sim {

/// A run with fluid and particles: injection, migration, clogging, from the case to its results.
/// Collective. @return the exit code
[[nodiscard]] int run_coupled_case(const config::Case& the_case, const RunOptions& options,
                                   const par::Communicator& comm, std::optional<Log>& log);

}  // namespace porefines::sim
