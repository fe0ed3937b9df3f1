// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <fstream>
#include <iosfwd>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace porefines {

/// Lines for the user, on the console and in log.txt at once.
///
/// Only rank 0 constructs one. Every line is flushed: the log is most wanted after a crash.
class Log {
 public:
  /// @param file      path of log.txt, overwritten; empty: console only
  /// @param console   usually std::cout; null: file only
  /// @param append    continue the file of a restarted run
  /// @throws RunError the file cannot be opened
  Log(const std::string& file, std::ostream* console, bool append = false);

  template <typename... Args>
  void info(fmt::format_string<Args...> format, Args&&... args) {
    write_line(fmt::format(format, std::forward<Args>(args)...));
  }

  template <typename... Args>
  void warn(fmt::format_string<Args...> format, Args&&... args) {
    write_line("warning: " + fmt::format(format, std::forward<Args>(args)...));
  }

 private:
  void write_line(std::string_view line);

  std::ofstream file_;
  std::ostream* console_;
};

}  // namespace porefines
