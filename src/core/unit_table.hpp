// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/units.hpp"

namespace porefines {

/// The SI value of one unit word with its prefix: "um", "mPa", "kg", "min", "darcy".
[[nodiscard]] std::optional<Quantity> find_unit(std::string_view word);

/// The unit that a wrong word most likely means: another capitalisation, or a long name.
/// Empty when nothing is close.
[[nodiscard]] std::string suggest_unit(std::string_view word);

}  // namespace porefines
