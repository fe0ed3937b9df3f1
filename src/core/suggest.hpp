// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace porefines {

/// Number of typing errors between two words: a letter added, dropped, replaced, or two neighbours
/// swapped (optimal string alignment). Cost: the product of the lengths.
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

/// The known word nearest to a mistyped one; empty when none is within a third of its length.
[[nodiscard]] std::string closest(std::string_view word, const std::vector<std::string>& known);

}  // namespace porefines
