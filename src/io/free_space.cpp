// SPDX-License-Identifier: MPL-2.0
#include "io/free_space.hpp"

#include <cerrno>
#include <csignal>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "core/error.hpp"

namespace porefines::io {

void require_space(const std::string& path, Index bytes, const std::string& what,
                   const std::string& advice) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  int failure = file < 0 ? errno : 0;
  if (file >= 0) {
    const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
    if (::fallocate(file, 0, 0, bytes) != 0 && errno != EOPNOTSUPP) {
      failure = errno;
    }
    std::signal(SIGXFSZ, old_handler);
    ::close(file);
    ::unlink(path.c_str());
  }
  if (failure != 0) {
    throw RunError(fmt::format("{}: cannot write {:.1f} MB of {}: {}; {}", path,
                               static_cast<Real>(bytes) / 1e6, what,
                               std::generic_category().message(failure), advice));
  }
}

}  // namespace porefines::io
