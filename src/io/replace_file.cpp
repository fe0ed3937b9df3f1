// SPDX-License-Identifier: MPL-2.0
#include "io/replace_file.hpp"

#include <cerrno>
#include <cstdio>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "core/error.hpp"

namespace porefines::io {
namespace {

/// Returns 0 or the errno of the first call that failed.
int write_synced(const std::string& path, std::string_view content) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) {
    return errno;
  }
  int failure = 0;
  while (!content.empty() && failure == 0) {
    const auto written = ::write(file, content.data(), content.size());
    if (written >= 0) {
      content.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      failure = errno;
    }
  }
  // Some file systems cannot sync (EINVAL); that is no reason to lose the file.
  if (failure == 0 && ::fsync(file) != 0 && errno != EINVAL) {
    failure = errno;
  }
  if (::close(file) != 0 && failure == 0) {
    failure = errno;
  }
  return failure;
}

}  // namespace

void replace_file(const std::string& path, std::string_view content) {
  const std::string part = path + ".part";
  int failure = write_synced(part, content);
  if (failure == 0 && std::rename(part.c_str(), path.c_str()) != 0) {
    failure = errno;
  }
  if (failure != 0) {
    ::unlink(part.c_str());
    throw RunError(fmt::format("{}: cannot write {} bytes: {}", path, content.size(),
                               std::generic_category().message(failure)));
  }
}

}  // namespace porefines::io
