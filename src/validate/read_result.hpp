// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

#include "validate/comparison.hpp"

namespace porefines::validate {

/// A number of a flat JSON file as porefines writes it; NaN: none.
[[nodiscard]] Real number_in(const std::string& path, const std::string& key);

/// The number that a row asks for.
struct Reading {
  Real value = 0;  ///< NaN: the run does not have it
  Real error = 0;  ///< half of an error bar; 0: none
};

/// @param folders  of the jobs of the comparison
/// Test: unit/validate_readings.
[[nodiscard]] Reading read_row(const Row& row, const std::vector<std::string>& folders);

/// Within its tolerance? A number that is not there is not.
[[nodiscard]] bool agrees(const Row& row, const Reading& reading);

}  // namespace porefines::validate
