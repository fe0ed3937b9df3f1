// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace porefines {

/// What the user gave is wrong: nothing was run, the program ends with exit code 2.
///
/// The message is one to three lines for a person: where (file, line, key), what was found,
/// and what to try.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& message) : std::runtime_error(message) {}
};

/// The simulation stopped itself (NaN, no convergence, full disk): exit code 3.
class RunError : public std::runtime_error {
 public:
  explicit RunError(const std::string& message) : std::runtime_error(message) {}
};

namespace exit_code {
inline constexpr int done = 0;
inline constexpr int wrong_input = 2;
inline constexpr int stopped_itself = 3;
inline constexpr int signal_base = 128;
}  // namespace exit_code

}  // namespace porefines
