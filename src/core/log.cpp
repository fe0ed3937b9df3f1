// SPDX-License-Identifier: MPL-2.0
#include "core/log.hpp"

#include <ostream>

#include "core/error.hpp"

namespace porefines {

Log::Log(const std::string& file, std::ostream* console, bool append) : console_(console) {
  if (file.empty()) {
    return;
  }
  file_.open(file, append ? std::ios::app : std::ios::trunc);
  if (!file_) {
    throw RunError(fmt::format("cannot write {}: does its folder exist, and is it yours?", file));
  }
}

void Log::write_line(std::string_view line) {
  if (console_ != nullptr) {
    *console_ << line << std::endl;
  }
  if (file_.is_open()) {
    file_ << line << std::endl;
  }
}

}  // namespace porefines
