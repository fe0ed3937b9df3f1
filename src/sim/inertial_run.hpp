// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <optional>

#include "config/case.hpp"
#include "core/log.hpp"
#include "par/communicator.hpp"
#include "sim/run.hpp"

namespace porefines::sim {

/// A flow with inertia through a case, in time or to the steady state: series.csv, fields, pictures,
/// summary.json with forces on bodies, Strouhal number and wake. Collective.
/// @return exit code
/// Tests: cli/inertial, validation/inertia.
[[nodiscard]] int run_inertial_case(const config::Case& the_case, const RunOptions& options,
                                    const par::Communicator& comm, std::optional<Log>& log);

}  // namespace porefines::sim
